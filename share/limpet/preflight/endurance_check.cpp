// SPDX-License-Identifier: MIT
// Whether the vehicle gets there, around and back: way, time, range, current.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "limpet/planning/region_fences.hpp"
#include "limpet/preflight/checks.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet::internal {
namespace {

constexpr double kTight = 1.3;  // lanes overlap, and objects want second looks

/// Lanes, plans and pilot are good to a current of this share of the cruising speed.
constexpr double kMostCurrent = 0.5;

/// The way of a whole session [m].
struct Ways {
  double transit = 0.0;  ///< from the start to the area, and at least as much back
  PathEstimate survey;
  double farthest_home = 0.0;     ///< from the far corner of the area
  bool is_by_way_points = false;  ///< of the transit, to the area and home
  [[nodiscard]] double there() const { return transit + survey.total(); }
  [[nodiscard]] double round() const { return there() + transit; }
};

/// Who starts inside the operating region needs no transit, on the way in or home.
bool StartsInRegion(const MissionReading& reading, const SurveyShape& shape,
                    const PlanePoint& start) {
  const Meters allowance(reading.Find("pHelm", "tracking_allowance_m")->number());
  const Meters margin(std::max(0.0, shape.margin() - allowance.value()));
  return HoldingFence(shape, margin, allowance).Clearance(start) >= 0.0;
}

/// There and home, by the transit's way points where they are flown.
void AddTransit(const MissionReading& reading, const SurveyFacts& survey, Ways& ways) {
  const auto shape = SurveyShape::Of(survey.area);
  if (!reading.scenario() || !shape) return;
  const Scenario::Start& start = reading.scenario()->start;
  PlanePoint at(start.north_m, start.east_m);
  ways.is_by_way_points = !shape->transit().empty() && !StartsInRegion(reading, *shape, at);
  double by_way_points = 0.0;
  if (ways.is_by_way_points) {
    for (const PlanePoint& next : shape->transit()) {
      by_way_points += (next - at).norm();
      at = next;
    }
  }
  ways.transit = by_way_points + survey.Outside(at);
  double farthest = 0.0;
  for (const PlanePoint& corner : shape->outline().corners())
    farthest = std::max(farthest, (corner - at).norm());
  ways.farthest_home = farthest + by_way_points;
}

Ways WaysOf(const MissionReading& reading, const SurveyFacts& survey) {
  Ways ways{.transit = 0.0,
            .survey = EstimatePath(survey, reading.Find("pSurvey", "coverage_kind")->text,
                                   reading.Find("pSurvey", "coverage_target")->number())};
  AddTransit(reading, survey, ways);
  return ways;
}

std::string TextOfWays(const Ways& ways) {
  return fmt::format("{:.0f} m of lanes, {:.0f} m of turns{}", ways.survey.lanes_m,
                     ways.survey.turns_m,
                     ways.transit > 0.0 ? fmt::format(", {:.0f} m to the area", ways.transit) : "");
}

void CheckTime(const MissionReading& reading, const SurveyFacts& survey, const Ways& ways,
               MissionProblems& found) {
  const Setting most = reading.Find("pSurvey", "max_time_s").value();
  const Setting align = reading.Find("pSurvey", "align_s").value();
  const double needed = align.number() + ways.there() / survey.speed.number();
  const auto text = [&](double time) {
    return fmt::format("the survey takes about {:.0f} s ({}, at {}; {}), and {} ends it", time,
                       TextOfWays(ways), survey.speed.Named(), align.Named(), most.Named());
  };
  if (needed > most.number()) {
    found.geometry.push_back(
        most.Refuse(text(needed) + fmt::format("; allowed: {:.0f} s or more", std::ceil(needed))));
  } else if (kTight * needed > most.number()) {
    found.notes.push_back(most.Refuse("is tight: " + text(needed)));
  }
}

void CheckRange(const MissionReading& reading, const Ways& ways, MissionProblems& found) {
  const std::vector<Setting> whens = reading.OfBehaviors("BHV_ReturnHome", "when");
  const std::vector<Setting> ranges = reading.OfBehaviors("BHV_ReturnHome", "range_m");
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (whens[i].text != "late") continue;
    const double needed = ways.round();
    const std::string text =
        fmt::format("{} allows less than the way of about {:.0f} m ({}, and home)",
                    ranges[i].Named(), needed, TextOfWays(ways));
    if (needed > ranges[i].number()) {
      found.geometry.push_back(
          ranges[i].Refuse(text + fmt::format("; allowed: {:.0f} m or more", std::ceil(needed))));
    } else if (kTight * needed > ranges[i].number()) {
      found.notes.push_back(ranges[i].Refuse("is tight: " + text));
    }
  }
}

/// pSurvey ends a mission where it is when the way home takes too long.
void CheckWayHome(const MissionReading& reading, const SurveyFacts& survey, const Ways& ways,
                  MissionProblems& found) {
  const Setting give_up = reading.Find("pSurvey", "give_up_s").value();
  const double duration = ways.farthest_home / survey.speed.number();
  if (duration > give_up.number()) {
    found.geometry.push_back(give_up.Refuse(fmt::format(
        "the way home from the far corner{}, {:.0f} m, takes {:.0f} s at {}; allowed: at least "
        "that",
        ways.is_by_way_points ? " by the transit" : "", ways.farthest_home, duration,
        survey.speed.Named())));
  }
}

/// Steady speed through the water at full thrust ahead [m/s].
double TopSpeed(const VehicleParams& vehicle) {
  const Hydrodynamics hydro = DeriveHydrodynamics(vehicle);
  const double thrust = vehicle.thrusters.max_thrust_n *
                        vehicle.thrusters.WrenchPerThrust().row(kSurge).cwiseAbs().sum();
  double low = 0.0, high = 20.0;
  for (int i = 0; i < 60; ++i) {
    const double speed = 0.5 * (low + high);
    (DragForce(hydro, kSurge, speed) < thrust ? low : high) = speed;
  }
  return low;
}

double MeanCurrent(const Scenario::Water& water) {
  return std::hypot(water.current_north_mps, water.current_east_mps);
}

/// The strongest that its tide lets it become, for as long as a way home takes [m/s].
double StrongestTide(const Scenario::Water& water) {
  const double strongest =
      water.current.tide_period > Seconds(0.0) ? 1.0 + water.current.tide_share : 1.0;
  return strongest * MeanCurrent(water);
}

/// The strongest that the scenario lets it become for a while, its unrest taken at two sigmas
/// [m/s].
double StrongestCurrent(const Scenario::Water& water) {
  constexpr double kSigmas = 2.0;
  return StrongestTide(water) + kSigmas * water.current.unrest_share * MeanCurrent(water);
}

void CheckCurrent(const MissionReading& reading, const SurveyFacts& survey,
                  MissionProblems& found) {
  if (reading.vehicle() && survey.speed.number() > reading.vehicle()->params.top_speed.value()) {
    found.geometry.push_back(survey.speed.Refuse(
        fmt::format("`{}` is faster than the vehicle is by its file; allowed: up to "
                    "hull.top_speed_mps, {:g} m/s",
                    survey.speed.text, reading.vehicle()->params.top_speed.value())));
    return;
  }
  if (!reading.Launches("uSimVehicle")) return;  // another vehicle has another top speed
  const double top = TopSpeed(
      LoadMissionVehicle(reading.mission().Global(kVehicleFileGlobal), reading.folder()).params);
  const double speed = survey.speed.number();
  if (speed > top) {
    found.geometry.push_back(survey.speed.Refuse(fmt::format(
        "`{}` is faster than the vehicle; allowed: up to {:.2f} m/s", survey.speed.text, top)));
  }
  if (!reading.scenario()) return;
  const Scenario::Water& water = reading.scenario()->water;
  const double current = StrongestCurrent(water);
  const bool is_north = std::abs(water.current_north_mps) >= std::abs(water.current_east_mps);
  const SourceLine where =
      reading.InScenario(is_north ? "current_north_mps:" : "current_east_mps:");
  constexpr double kRounding = 1e-3;  // of components in text [m/s]
  const double most = std::min(kMostCurrent * speed, std::max(0.0, top - speed));
  if (current <= most + kRounding) return;
  const std::string made_of =
      water.current.unrest_share > 0.0
          ? fmt::format(" (it is {:.2f} m/s on average; two sigmas of its unrest are counted)",
                        MeanCurrent(water))
          : "";
  const bool is_carried = current >= speed || current + speed > top;
  found.geometry.push_back(
      {where, "water",
       fmt::format("a current of {:.2f} m/s {}; allowed: up to {:.2f} m/s{}", current,
                   is_carried
                       ? fmt::format("carries the vehicle away: {}, and it makes {:.2f} m/s "
                                     "through the water at most",
                                     survey.speed.Named(), top)
                       : fmt::format("is more than half of the cruising speed, {}: no survey is "
                                     "good in it",
                                     survey.speed.Named()),
                   most, made_of)});
}

}  // namespace

void CheckEndurance(const MissionReading& reading, const SurveyFacts& survey,
                    MissionProblems& found) {
  if (survey.speed.number() <= 0.0 || survey.north_extent() <= 0.0 || survey.east_extent() <= 0.0) {
    return;
  }
  const Ways ways = WaysOf(reading, survey);
  CheckTime(reading, survey, ways, found);
  CheckRange(reading, ways, found);
  CheckWayHome(reading, survey, ways, found);
  CheckCurrent(reading, survey, found);
  CheckEnergy(reading, survey,
              {.out_m = ways.there(),
               .home_m = ways.farthest_home,
               .current_mps = reading.scenario() ? StrongestTide(reading.scenario()->water) : 0.0},
              found);
  const double margin = reading.Find("pSurvey", "margin_m")->number();
  if (ways.transit > margin) {
    found.notes.push_back(
        {reading.InScenario("start:"), "start",
         fmt::format("is {:.0f} m {} the area; the way in and back is part of the session",
                     ways.transit,
                     ways.is_by_way_points ? "of way, by the transit, from" : "outside")});
  }
}

}  // namespace limpet::internal
