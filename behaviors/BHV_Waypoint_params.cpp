// SPDX-License-Identifier: MIT
#include <algorithm>

#include "behaviors/BHV_Waypoint.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/waypoints/map_params.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

using Params = BHV_Waypoint::Params;

bool ReadPoints(std::string_view text, Params& params) {
  const std::string word = LowerCase(Trim(text));
  if (word == "start" || word == "empty") {
    params.points_from = word;
    params.points.clear();
    return true;
  }
  const auto points = ParsePoints(text);
  if (!points) return false;
  params.points = *points;
  params.points_from = "list";
  return true;
}

/// `slow_dist=20, stop_dist=5`.
bool ReadEndSpeed(std::string_view text, Params& params) {
  std::optional<double> slow, stop;
  for (const std::string& part : Split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return false;
    const std::string_view key = Trim(std::string_view(part).substr(0, equals));
    const auto value = ParseNumber(Trim(std::string_view(part).substr(equals + 1)));
    (key == "slow_dist" ? slow : stop) = value;
    if (key != "slow_dist" && key != "stop_dist") return false;
  }
  if (!slow || !stop || *stop < 0.0 || *slow < *stop || *slow <= 0.0) return false;
  params.slow_distance = *slow;
  params.stop_distance = *stop;
  return true;
}

void DescribeWay(ParamCollector& visit, Params& params) {
  constexpr const char* kPoints = "x,y : x,y ..., pts={...}, format=..., start or empty";
  visit.Parsed("points", kPoints, "Where to go: x east, y north of the datum [m]", "empty",
               [&params](std::string_view text) { return ReadPoints(text, params); });
  visit.Also({"polygon", "point", "xpoints"});
  visit.Parsed("newpt", "x,y", "One more point, at the end", "", [&params](std::string_view text) {
    params.added = text.empty() ? std::nullopt : ParsePoint(text);
    return text.empty() || params.added.has_value();
  });
  visit.Parsed("order", "normal, reverse, toggle", "Which point comes first", "normal",
               [&params](std::string_view text) {
                 params.order = text == "reversed" ? "reverse" : std::string(text);
                 return params.order == "normal" || params.order == "reverse" ||
                        params.order == "toggle";
               });
  DescribeRepeats(visit, params.repeats);
  visit.Parsed("currix", "a whole number", "Index of the next point, from 0", "",
               [&params](std::string_view text) {
                 const auto index = ParseInteger(text);
                 if (index && *index >= 0) params.index = static_cast<int>(*index);
                 return text.empty() || (index && *index >= 0);
               });
  TakeWholePart(visit);
  visit("greedy_tour", params.is_greedy, "Order the points: always to the nearest one left");
  visit.Also({"shortest_tour"});
  visit("reset_on_idle", params.is_reset_on_idle, "Begin at the first point after each idle spell");
}

void DescribeLegs(ParamCollector& visit, Params& params) {
  DescribeCapture(visit, params.capture);
  DescribeLead(visit, params.lead);
  visit("lead_to_start", params.leads_to_start, "Lead on the way to the first point, too");
  visit.ParsedLines("lead_condition", "a condition", "Lead only while all of them hold",
                    [&params](std::string_view text) {
                      auto condition = Condition::ParseWithCommas(text);
                      if (!condition) return false;
                      params.lead_conditions.push_back(*std::move(condition));
                      return true;
                    });
}

void DescribeSpeed(ParamCollector& visit, Params& params) {
  visit("speed", params.speed, "Speed on the way",
        InRange(MetersPerSecond(0.0), MetersPerSecond(100.0)));
  visit.Parsed("speed_alt", "a number in mps; below 0: none", "Another speed", "-1",
               [&params](std::string_view text) {
                 const auto speed = ParseNumber(text);
                 if (!speed) return false;
                 params.speed_alt =
                     *speed < 0.0 ? std::nullopt : std::optional(MetersPerSecond(*speed));
                 return true;
               });
  visit("use_alt_speed", params.uses_alt_speed, "Go at speed_alt, if there is one");
  DescribePatience(visit, params.patience);
  visit.Also({"crs_spd_zaic_ratio"});
  visit.Parsed(
      "end_spd", "slow_dist=..., stop_dist=...",
      "Slow down before the end of the way, and stop [m]", "",
      [&params](std::string_view text) { return text.empty() || ReadEndSpeed(text, params); });
}

void DescribePosts(ParamCollector& visit, Params& params) {
  const auto flags = [&visit](const char* name, std::vector<Flag>& list, const char* help) {
    visit.ParsedLines(name, "VARIABLE = value", help,
                      [&list](std::string_view text) { return AddFlag(text, list); });
  };
  flags("wptflag", params.waypoint_flags, "Posted at each point");
  flags("cycleflag", params.cycle_flags, "Posted at the end of each round");
  visit("wptflag_on_start", params.has_flags_on_start, "Post wptflag as the way begins, too");
  DescribeVariable(visit, "wpt_status_var", params.status_variable,
                   "Where the status goes; silent: nowhere");
  visit.Also({"wpt_status"});
  DescribeVariable(visit, "wpt_index_var", params.index_variable,
                   "Where the next point's index goes");
  visit.Also({"wpt_index"});
  DescribeVariable(visit, "cycle_index_var", params.cycle_variable,
                   "Where the rounds' number goes");
  DescribeVariable(visit, "wpt_dist_to_prev", params.previous_distance_variable,
                   "Where the distance from the last point goes");
  DescribeVariable(visit, "wpt_dist_to_next", params.next_distance_variable,
                   "Where the distance to the next point goes");
  visit.Parsed("efficiency_measure", "off, all",
               "all: WPT_EFF_*, how directly and how fast legs are travelled", "off",
               [&params](std::string_view text) {
                 const std::string word = LowerCase(text);
                 params.measures_efficiency = word == "all";
                 return word == "all" || word == "off";
               });
  DescribeSuffix(visit, "post_suffix", params.suffix);
  DescribeHints(visit, params.hints);
}

}  // namespace

void BHV_Waypoint::Params::Describe(ParamCollector& visit) {
  DescribeWay(visit, *this);
  DescribeLegs(visit, *this);
  DescribeSpeed(visit, *this);
  DescribePosts(visit, *this);
  visit.Parsed("ipf_type", "text",
               "What it prefers. zaic: the way's course and speed, each by itself; zaic_spd: "
               "rather slower than faster; roc, rate_of_closure: to come nearer at that speed",
               "zaic", [this](std::string_view text) {
                 // Other words leave it alone, as there.
                 const std::string word = LowerCase(text);
                 const bool is_known = word == "zaic" || word == "zaic_spd" || word == "roc" ||
                                       word == "rate_of_closure";
                 if (is_known) function_kind = word;
                 return true;
               });
  visit.Also({"ipf-type"});
  visit.WithoutEffect({"eager_prev_index_flag", "draw_path_loop"});
}

}  // namespace limpet
