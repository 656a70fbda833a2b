// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ZigZag.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {
namespace {

using ZigZagParams = BHV_ZigZag::Params;

/// Turns of a zig and a zag; the same as twice as many legs.
bool ReadPairs(std::string_view text, ZigZagParams& params) {
  constexpr int kMost = 1'000'000;
  const auto pairs = ParseInteger(text);
  if (text.empty()) return true;
  if (!pairs || *pairs < 1 || *pairs > kMost) return false;
  params.legs = 2 * static_cast<int>(*pairs);
  return true;
}

void DescribeTurns(ParamCollector& visit, ZigZagParams& params) {
  visit("zig_angle", params.angle, "How far the legs head off the stem",
        InRange(Radians::FromTextUnit(0.0), Radians::FromTextUnit(75.0)));
  visit("hdg_thresh", params.threshold, "A turn is finished this near to its heading",
        InRange(Radians::FromTextUnit(0.0), Radians::FromTextUnit(90.0)));
  visit.Parsed("zig_first", "port, star, left, right or starboard", "Side of the first leg", "port",
               [&params](std::string_view text) {
                 const auto is_port = ParseIsPort(text);
                 params.begins_to_port = is_port.value_or(true);
                 return is_port.has_value();
               });
  visit("fierce_zigging", params.is_fierce,
        "Steer always as far off the present heading, until the turn is finished");
  visit.Parsed("zig_angle_fierce", "1 to 75 deg", "How far off then; else as zig_angle", "",
               [&params](std::string_view text) {
                 const auto degrees = ParseNumber(text);
                 if (text.empty()) return true;
                 if (!degrees || *degrees < 1.0 || *degrees > 75.0) return false;
                 params.fierce_angle = Radians::FromTextUnit(*degrees);
                 return true;
               });
  visit.Also({"delta_heading"});
  visit("max_zig_legs", params.legs,
        "Complete after so many legs and the half one from the stem; 0: never",
        InRange(0, 2'000'000));
  visit.Parsed("max_zig_zags", "a whole number from 1", "max_zig_legs in pairs of legs", "",
               [&params](std::string_view text) { return ReadPairs(text, params); });
  visit.Number("max_stem_odo", -1.0, "Complete so far along the stem [m]; not above 0: no limit",
               InRange(-1.0, 1e6), [&params](double length) {
                 params.longest_stem = length > 0.0 ? std::optional(Meters(length)) : std::nullopt;
               });
}

}  // namespace

void BHV_ZigZag::Params::Describe(ParamCollector& visit) {
  visit("stem_hdg", stem_heading, "Heading of the stem, clockwise from north; 370 is 10",
        InRange(Radians::FromTextUnit(-36000.0), Radians::FromTextUnit(36000.0)));
  visit("stem_on_active", takes_heading, "Take the heading that it begins with instead");
  visit("speed", speed, "Speed to keep", InRange(MetersPerSecond(0.0), MetersPerSecond(100.0)));
  visit("spd_on_active", takes_speed, "Take the speed that it begins with instead");
  visit.Also({"speed_on_active"});
  visit.Parsed("mod_speed", "a number in mps, or reset",
               "By an update: so much faster or slower than now", "reset",
               [this](std::string_view text) {
                 speed_change = ParseNumber(text);
                 return speed_change || EqualsIgnoringCase(text, "reset");
               });
  DescribeTurns(visit, *this);
  DescribeFlags(visit, "zigflag", zig_flags, "Posted when a leg is finished");
  DescribeFlags(visit, "zagflag", zag_flags, "Posted when a pair of legs is finished");
  DescribeFlags(visit, "portflag", port_flags, "Posted as a leg to port begins");
  DescribeFlags(visit, "starflag", starboard_flags, "Posted as a leg to starboard begins");
  DescribeFlags(visit, "portflagx", port_end_flags, "Posted when a leg to port is finished");
  DescribeFlags(visit, "starflagx", starboard_end_flags,
                "Posted when a leg to starboard is finished");
  DescribeHints(visit, hints);
}

}  // namespace limpet
