// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// What a survey is to cover and when it ends: the mission manager's block (pSurvey).
struct SurveyParams {
  /// A rectangle, or the corners of `area`: AreaOf (mission_area.hpp) makes the area of them.
  std::optional<Meters> north_min, north_max, east_min, east_max;
  std::string area, area_geojson;
  std::vector<std::string> keep_out;
  std::string operating_region, transit;
  Meters margin{2.0};
  Meters object_height_max{2.0};
  Meters altitude{4.0};
  Meters altitude_tolerance{0.3};
  Seconds align{300.0};
  Seconds last_fix{300.0};
  Seconds fix_wait_min{20.0};
  Meters fix_target{0.36}, former_fix_target{0.36}, last_fix_target{0.3};
  double coverage_target = 0.975;
  std::string coverage_kind = "band_top";
  Meters home_radius{1.0};
  Meters surface_depth{0.35};
  Seconds stall{240.0};
  Seconds max_time{5400.0};
  Seconds lost{300.0};
  Seconds give_up{1800.0};
  double energy_reserve_percent = 15.0;
  template <class Visitor>
  void Describe(Visitor& visit) {
    visit.Optional("area_north_min_m", north_min, "South edge of a rectangular area",
                   Meters(-15.0));
    visit.Optional("area_north_max_m", north_max, "North edge of a rectangular area", Meters(15.0));
    visit.Optional("area_east_min_m", east_min, "West edge of a rectangular area", Meters(-18.0));
    visit.Optional("area_east_max_m", east_max, "East edge of a rectangular area", Meters(18.0));
    visit("area", area,
          "In place of the four edges the corners of any polygon that does not cross itself, "
          "pts={x,y:x,y:x,y}, x east and y north [m]");
    visit("area_geojson", area_geojson,
          "In place of those a file beside the mission with one polygon, GeoJSON or KML: its holes "
          "are zones to keep out of");
    visit(
        "keep_out", keep_out,
        "A polygon that the vehicle does not enter and whose ground is not to be seen, as `area`");
    visit("operating_region", operating_region,
          "A polygon that the vehicle does not leave, as `area`; empty: the area and margin_m");
    visit(
        "transit", transit,
        "Way points from the start to the area where the straight way is blocked, as `area`; home "
        "goes back by them");
    visit("margin_m", margin,
          "Strip around the area that the vehicle may use, if no operating_region is given",
          InRange(Meters(0.0), Meters(100.0)));
    visit.Required("object_height_max_m", object_height_max,
                   "Objects float up to this height above the seabed; 0 covers the bottom alone",
                   InRange(Meters(0.0), Meters(10.0)));
    visit.Required("altitude_m", altitude,
                   "Survey altitude; the dive ends within altitude_tolerance_m of it",
                   InRange(Meters(0.5), Meters(50.0)));
    visit("altitude_tolerance_m", altitude_tolerance, "How near the altitude must be",
          InRange(Meters(0.05), Meters(5.0)));
    DescribeFixes(visit);
    visit("coverage_target", coverage_target, "Share of the area to see before going home",
          InRange(0.0, 1.0));
    visit.Choice(
        "coverage_kind", coverage_kind,
        "What the target counts: the bottom, the mean over the band, or its greatest height",
        {"seabed", "band", "band_top"});
    visit("home_radius_m", home_radius, "Home is reached within this distance",
          InRange(Meters(0.2), Meters(50.0)));
    visit("surface_depth_m", surface_depth, "Shallower than this is at the surface",
          InRange(Meters(0.0), Meters(5.0)));
    visit("stall_s", stall,
          "Go home when coverage has not grown, or on the way to the area that has not come "
          "nearer, for this long",
          InRange(Seconds(10.0), Seconds(86400.0)));
    visit("max_time_s", max_time, "Go home after this time under way",
          InRange(Seconds(10.0), Seconds(864000.0)));
    visit("lost_s", lost, "End the mission, lost, after this time under way without NAV_STATE",
          InRange(Seconds(10.0), Seconds(86400.0)));
    visit("energy_reserve_percent", energy_reserve_percent,
          "What of a full battery is to be left at home (ENERGY_STATE)", InRange(0.0, 90.0));
    visit("give_up_s", give_up,
          "End the mission where it is if diving, returning or ascending takes longer",
          InRange(Seconds(10.0), Seconds(86400.0)));
  }
  /// The waits at the surface.
  template <class Visitor>
  void DescribeFixes(Visitor& visit) {
    visit("align_s", align, "Longest time at the surface to collect GPS fixes before the dive",
          InRange(Seconds(0.0), Seconds(3600.0)));
    visit("last_fix_s", last_fix,
          "Longest time at the surface at the end: later GPS fixes are independent of the first "
          "ones",
          InRange(Seconds(0.0), Seconds(3600.0)));
    visit("fix_wait_min_s", fix_wait_min,
          "Shortest time of both, unless they are shorter: reflections put fixes off for seconds",
          InRange(Seconds(0.0), Seconds(3600.0)));
    visit("fix_target_m", fix_target,
          "The dive begins when the 1-sigma of north and of east (NAV_STATE) is down to this",
          InRange(Meters(0.01), Meters(100.0)));
    visit("former_fix_target_m", former_fix_target,
          "1-sigma for the dive to begin where a former session has two objects or more, if larger "
          "than fix_target_m: seen again, they tie this session to that one's fixes",
          InRange(Meters(0.01), Meters(100.0)));
    visit("last_fix_target_m", last_fix_target,
          "The mission ends when the fixes at home have brought that 1-sigma down to this",
          InRange(Meters(0.01), Meters(100.0)));
  }
  /// No mission takes longer, whatever happens: each phase ends by itself, and after `max_time`
  /// the vehicle goes home. From DEPLOY to MISSION_END.
  [[nodiscard]] Seconds Longest() const {
    const Seconds dive_ends = align + give_up;
    return std::max(max_time, dive_ends) + 2.0 * give_up + lost + last_fix;
  }
};

}  // namespace limpet
