// SPDX-License-Identifier: MIT
#include <string>

#include "behaviors/BHV_OpRegionV24.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/waypoints/map_params.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

using RegionParams = BHV_OpRegionV24::Params;

void DescribePolygon(ParamCollector& visit, const char* name, std::optional<ConvexPolygon>& field,
                     const char* help) {
  visit.Parsed(name, "x,y : x,y ..., pts={...} or format=radial, ...; convex", help, "",
               [&field](std::string_view text) {
                 if (text.empty()) return true;
                 auto corners = ParsePoints(text);
                 if (!corners) return false;
                 field = ConvexPolygon::Of(*std::move(corners));
                 return field.has_value();
               });
}

/// A number from 0 on; `is_off_at_zero`: 0 is none.
template <class Number>
void DescribeLimit(ParamCollector& visit, const char* name, std::optional<Number>& field,
                   const char* form, const char* help, bool is_off_at_zero) {
  visit.Parsed(name, form, help, is_off_at_zero ? "0" : "",
               [&field, is_off_at_zero](std::string_view text) {
                 constexpr double kMost = 1e7;
                 if (text.empty() && !is_off_at_zero) return true;
                 const auto value = ParseNumber(text);
                 if (!value || *value < 0.0 || *value > kMost) return false;
                 field.reset();
                 if (*value > 0.0 || !is_off_at_zero) field = Number(*value);
                 return true;
               });
}

void DescribeDistances(ParamCollector& visit, RegionParams& params) {
  DescribePolygon(
      visit, "core_poly", params.core,
      "Where it is to stay, which save_dist and halt_dist are about: x east, y north of "
      "the datum [m]");
  DescribePolygon(visit, "save_poly", params.save, "Outside of this it steers back");
  DescribeLimit(visit, "save_dist", params.save_distance, "m, from 0",
                "In place of save_poly: so far about core_poly", false);
  DescribeLimit(visit, "halt_dist", params.halt_distance, "m, from 0",
                "In place of halt_poly: so far about core_poly", false);
  DescribeVariable(visit, "dynamic_region_var", params.core_variable,
                   "Mail of this is another core_poly");
}

void DescribeFlagsOf(ParamCollector& visit, RegionParams& params, const std::string& key) {
  DescribeFlags(visit, "breached_poly_flag", params.poly_flags,
                ("Posted as it has left " + key).c_str());
  DescribeFlags(visit, "breached_time_flag", params.time_flags, "Posted as max_time is over");
  DescribeFlags(visit, "breached_altitude_flag", params.altitude_flags, "Posted as it is too low");
  DescribeFlags(visit, "breached_depth_flag", params.depth_flags, "Posted as it is too deep");
}

}  // namespace

void BHV_OpRegionV24::Params::DescribeLimits(ParamCollector& visit, const char* key) {
  halt_key = key;
  DescribePolygon(visit, key, halt,
                  "Outside of this it stops the vehicle: x east, y north of the datum [m]");
  visit("trigger_entry_time", entry_time, "How long inside before the polygon counts",
        InRange(Seconds(0.0), Seconds(1e6)));
  visit("trigger_exit_time", exit_time, "Outside for so long it stops the vehicle",
        InRange(Seconds(0.0), Seconds(1e6)));
  DescribeLimit(visit, "max_depth", deepest, "m; 0: none", "Deeper it stops the vehicle", true);
  DescribeLimit(visit, "min_altitude", least_altitude, "m; 0: none",
                "Nearer to the seabed, or without a say on that, it stops the vehicle", true);
  DescribeLimit(visit, "max_time", longest, "s; 0: none",
                "So long after the helm began it stops the vehicle", true);
  DescribeVariable(visit, "reset_var", reset_variable,
                   "As if the helm had just begun, whenever this is written `true`");
  DescribeFlagsOf(visit, *this, key);
  DescribeHints(visit, hints);
}

void BHV_OpRegionV24::Params::Describe(ParamCollector& visit) {
  DescribeDistances(visit, *this);
  DescribeLimits(visit, "halt_poly");
  visit("trigger_on_poly_entry", waits_for_entry,
        "halt_poly counts once the vehicle has been inside");
  visit("recover_speed", recover_speed, "Speed on the way back",
        InRange(MetersPerSecond(0.0), MetersPerSecond(100.0)));
  visit.Also({"recover_spd"});
  visit("reset", is_reset, "By an update: as if the helm had just begun");
  DescribeFlags(visit, "save_flag", save_flags, "Posted as it leaves save_poly");
  DescribeFlags(visit, "savex_flag", savex_flags, "Posted in each iteration outside save_poly");
  visit("draw_save_status", draws_save, "Draw a ring about the vehicle while it steers back");
  visit("draw_halt_status", draws_halt, "Draw one while it is outside halt_poly");
}

}  // namespace limpet
