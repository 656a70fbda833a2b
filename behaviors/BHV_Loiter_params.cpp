// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "behaviors/BHV_Loiter.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/waypoints/map_params.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

using LoiterParams = BHV_Loiter::Params;

bool ReadPolygon(std::string_view text, LoiterParams& params) {
  auto points = ParsePoints(text);
  if (!points) return false;
  for (MapPoint& point : *points) {  // corners to a tenth of a metre
    constexpr double kPerMetre = 10.0;
    point = {std::round(point.x * kPerMetre) / kPerMetre,
             std::round(point.y * kPerMetre) / kPerMetre};
  }
  params.polygon = ConvexPolygon::Of(*std::move(points));
  return params.polygon.has_value();
}

bool ReadCenter(std::string_view text, LoiterParams& params) {
  params.center_assign = text;
  const bool is_half = text.find(',') == std::string_view::npos && text.find('=') == 1;
  return text.empty() || EqualsIgnoringCase(text, "present_position") || ParsePoint(text) ||
         (is_half && (text[0] == 'x' || text[0] == 'y') && ParseNumber(text.substr(2)));
}

bool ReadSuffix(std::string_view text, LoiterParams& params) {
  if (text.find_first_of(" \t") != std::string_view::npos) return false;
  params.suffix = text.empty() ? "" : "_" + UpperCase(text);
  return true;
}

void DescribePlace(ParamCollector& visit, LoiterParams& params) {
  visit.Parsed("polygon", "x,y : x,y ..., pts={...} or format=radial, ...; convex",
               "Where: x east, y north of the datum [m]", "", [&params](std::string_view text) {
                 return text.empty() || ReadPolygon(text, params);
               });
  visit.Parsed("center_assign", "x,y or x=... or y=... or present_position",
               "Puts the polygon's center there", "",
               [&params](std::string_view text) { return ReadCenter(text, params); });
  const auto coordinate = [&visit](const char* name, std::optional<double>& field) {
    visit.Parsed(name, "a number in m", "Puts one coordinate of its center there", "",
                 [&field](std::string_view text) {
                   field = ParseNumber(text);
                   return text.empty() || field.has_value();
                 });
  };
  coordinate("xcenter_assign", params.center_x);
  coordinate("ycenter_assign", params.center_y);
  visit("center_activate", params.is_center_activated,
        "Put the center where the vehicle is, whenever it begins to run");
  visit("mod_poly_rad", params.growth, "Move the corners so much outward [m]",
        InRange(-100000.0, 100000.0));
}

}  // namespace

void BHV_Loiter::Params::Describe(ParamCollector& visit) {
  DescribePlace(visit, *this);
  visit("speed", speed, "Speed on the rounds",
        InRange(MetersPerSecond(0.0), MetersPerSecond(100.0)));
  visit.Parsed("speed_alt", "a number in mps; below 0: none", "Another speed", "-1",
               [this](std::string_view text) {
                 const auto value = ParseNumber(text);
                 if (!value) return false;
                 speed_alt = *value < 0.0 ? std::nullopt : std::optional(MetersPerSecond(*value));
                 return true;
               });
  visit("use_alt_speed", uses_alt_speed, "Go at speed_alt, if there is one");
  visit.Parsed("clockwise", "true, false or best", "Direction of the rounds", "true",
               [this](std::string_view text) {
                 const auto flag = ParseFlag(text);
                 clockwise = flag ? (*flag ? "true" : "false") : "best";
                 return flag || EqualsIgnoringCase(text, "best");
               });
  visit("capture_radius", capture.capture_radius, "A corner this near is reached [m]",
        InRange(0.0, 10000.0));
  visit.Also({"radius"});
  visit("slip_radius", capture.slip_radius,
        "Reached, too, when the distance grows again within this [m]", InRange(0.0, 10000.0));
  visit.Also({"nm_radius"});
  visit("acquire_dist", acquire_distance, "Further outside than this it heads for the best corner",
        InRange(Meters(0.0), Meters(100000.0)));
  visit.Also({"acquire_distance"});
  visit.Number("slingshot", -1.0, "Complete after so much of a round [deg]; below 0: never",
               InRange(-1.0, 36000.0), [this](double degrees) {
                 slingshot =
                     degrees < 0.0 ? std::nullopt : std::optional(Radians::FromTextUnit(degrees));
               });
  visit(
      "spiral_factor", spiral_factor,
      "From inside: 0 keeps on ahead, 100 turns for the best corner; beyond, as the nearer of them",
      InRange(-1e6, 1e6));
  visit.Parsed("post_suffix", "text",
               "Added to the names of status variables in capitals, after `_`", "",
               [this](std::string_view text) { return ReadSuffix(text, *this); });
  DescribeHints(visit, hints);
  DescribePatience(visit, patience);
  visit.Parsed("ipf_type", "text",
               "zaic_spd: rather slower than faster; other words: as fast as told", "zaic",
               [this](std::string_view text) {
                 prefers_slower = EqualsIgnoringCase(text, "zaic_spd");
                 return true;
               });
  visit.Also({"ipf-type"});
}

}  // namespace limpet
