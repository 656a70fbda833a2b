// SPDX-License-Identifier: MIT
#include <algorithm>

#include "behaviors/BHV_AvoidObstacle.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/waypoints/map_params.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

using ObstacleParams = BHV_AvoidObstacle::Params;

/// `rock` of `pts={...},label=rock` and the key `label=`, or nothing.
std::string FieldOf(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos) return "";
  const std::string_view rest = text.substr(at + key.size());
  return std::string(Trim(rest.substr(0, rest.find(','))));
}

bool ReadObstacle(std::string_view text, ObstacleParams& params) {
  auto corners = ParsePoints(text);
  if (!corners) return false;
  params.polygon = ConvexPolygon::Of(*std::move(corners));
  params.label = FieldOf(text, "label=");
  params.source = FieldOf(text, "vsource=");
  return params.polygon.has_value();
}

/// A distance [m] that is not to be below `low` nor above `high`, as far as those are given before
/// it.
struct Distance {
  std::optional<double>* value;
  std::vector<const std::optional<double>*> low{}, high{};

  [[nodiscard]] bool Allows(double distance) const {
    return std::ranges::none_of(low, [&](const auto* at) { return *at > distance; }) &&
           std::ranges::none_of(high, [&](const auto* at) { return *at && **at < distance; });
  }
};

void DescribeDistance(ParamCollector& visit, const char* name, const char* form, const char* help,
                      Distance distance) {
  visit.Parsed(name, form, help, "", [distance = std::move(distance)](std::string_view text) {
    if (text.empty()) return true;
    const auto value = ParseNumber(text);
    if (!value || *value < 0.0) return false;
    *distance.value = value;
    return distance.Allows(*value);
  });
}

}  // namespace

void BHV_AvoidObstacle::Params::Describe(ParamCollector& visit) {
  visit.Parsed("poly", "x,y : x,y ..., pts={...} or format=radial, ...; convex",
               "The obstacle: x east, y north of the datum [m]", "",
               [this](std::string_view text) { return text.empty() || ReadObstacle(text, *this); });
  visit.Also({"polygon"});
  visit("id", id, "Of the obstacle, as OBM_RESOLVED names it");
  visit.Also({"obid"});
  visit(
      "allowable_ttc", allowable_time,
      "Courses that come near later than this, at each speed, are a quarter better than those that "
      "do sooner",
      InRange(Seconds(0.0), Seconds(1e5)));
  DescribeDistance(visit, "min_util_cpa_dist", "m, at most max_util_cpa_dist",
                   "A way that comes this near is worth nothing; else 8 m",
                   {.value = &least_approach, .high = {&free_approach}});
  DescribeDistance(visit, "max_util_cpa_dist", "m, at least min_util_cpa_dist",
                   "One that stays this far off is as good as any; else 16 m",
                   {.value = &free_approach, .low = {&least_approach}});
  visit.Parsed("buffer_dist", "m, from 0",
               "In old missions: min_util_cpa_dist and max_util_cpa_dist at once", "",
               [this](std::string_view text) {
                 if (text.empty()) return true;
                 const auto value = ParseNumber(text);
                 if (!value || *value < 0.0) return false;
                 least_approach = free_approach = value;
                 return true;
               });
  DescribeDistance(visit, "pwt_inner_dist", "m, at most pwt_outer_dist and completed_dist",
                   "From here on it has its full weight; else 10 m",
                   {.value = &inner_distance, .high = {&outer_distance, &end_distance}});
  DescribeDistance(visit, "pwt_outer_dist", "m, from pwt_inner_dist to completed_dist",
                   "Further off it has no say; else 50 m",
                   {.value = &outer_distance, .low = {&inner_distance}, .high = {&end_distance}});
  DescribeDistance(visit, "completed_dist", "m, at least pwt_inner_dist and pwt_outer_dist",
                   "Once further off than this again it completes; else 50 m",
                   {.value = &end_distance, .low = {&inner_distance, &outer_distance}});
  visit("draw_buff_min_poly", draws_least, "Draw where ways are worth nothing");
  visit("draw_buff_max_poly", draws_free, "Draw where ways are worth less");
  visit.ParsedLines("rng_flag", "[<m] VARIABLE = value", "Posted while nearer than so many metres",
                    [this](std::string_view text) { return AddFlag(text, range_flags); });
  DescribeFlags(visit, "cpa_flag", approach_flags, "Posted when it gets farther again");
  DescribeHints(visit, hints);
  visit("allstop_on_breach", stops_inside,
        "Inside the obstacle it stops the vehicle; false: it leads out of it");
  visit("can_disable", can_be_silenced,
        "Heed BHV_ABLE_FILTER, e.g. action=disable,obstacle_id=7 (or enable, expunge; "
        "vsource=radar)");
  visit.WithoutEffect({"use_refinery", "holonomic_ok", "no_alert_request", "obstacle_key",
                       "resolved", "i_understand_this_behavior_is_deprecated"});
}

double BHV_AvoidObstacle::Params::least() const {
  constexpr double kUsual = 8.0;
  return least_approach.value_or(std::min(kUsual, free_approach.value_or(kUsual)));
}

double BHV_AvoidObstacle::Params::free() const {
  constexpr double kUsual = 16.0;
  return free_approach.value_or(std::max(kUsual, least()));
}

double BHV_AvoidObstacle::Params::inner() const {
  constexpr double kUsual = 10.0;
  return inner_distance.value_or(
      std::min({kUsual, outer_distance.value_or(kUsual), end_distance.value_or(kUsual)}));
}

double BHV_AvoidObstacle::Params::outer() const {
  constexpr double kUsual = 50.0;
  return outer_distance.value_or(
      std::max(inner(), std::min(kUsual, end_distance.value_or(kUsual))));
}

double BHV_AvoidObstacle::Params::end() const {
  constexpr double kUsual = 50.0;
  return end_distance.value_or(std::max(kUsual, outer()));
}

}  // namespace limpet
