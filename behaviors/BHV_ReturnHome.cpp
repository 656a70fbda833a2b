// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ReturnHome.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limpet/helm/registry.hpp"
#include "limpet/planning/home_path.hpp"

namespace limpet {
namespace {

/// No option is longer. Nearer to the end of the battery's reach than this and the
/// way home, a way home has to be among the options, since all others may be refused.
constexpr double kLongestOption_m = 200.0;

double DistanceHome(const Pose2& from, const Situation& now) {
  return std::hypot(from.north - now.home.north, from.east - now.home.east);
}

/// How much longer than its own part an option is. Options are ranked by what a metre brings: so
/// much more is charged for what is due to that part.
double WholeByOwn(const Prospect& prospect) {
  return prospect.whole().length() / std::max(1e-3, prospect.length());
}

/// Path that the battery allows [m].
double ReachOf(const Situation& now) {
  return now.reach ? now.reach->value() : std::numeric_limits<double>::infinity();
}

}  // namespace

void BHV_ReturnHome::Shape(const Situation& now, double, SearchGoals& goals) const {
  const double way_home = 1.2 * DistanceHome(now.pose, now);
  const bool is_near_the_limit = now.travelled + way_home > 0.9 * params_.range.value() ||
                                 way_home + kLongestOption_m > ReachOf(now);
  if (params_.when == "now" || is_near_the_limit) {
    goals.destinations.push_back({.north = now.home.north, .east = now.home.east});
  }
}

std::optional<Bid> BHV_ReturnHome::Value(const Prospect& prospect, const Situation& now) const {
  const double to_go = prospect.length() + DistanceHome(prospect.path().end(), now);
  if (params_.when == "now") {
    return Bid{.value = -to_go, .why = {{"to_go", to_go}}, .veto = {}};
  }
  const double beyond_battery = to_go - ReachOf(now);
  const double overrun =
      std::max({0.0, now.travelled + to_go - params_.range.value(), beyond_battery});
  Bid bid{.value = -params_.lateness_weight * overrun * WholeByOwn(prospect),
          .why = {{"overrun", overrun}},
          .veto = {}};
  if (prospect.option->is_whole()) {
    const Pose2& end = prospect.whole().end();
    const double from_end = (PlanePoint(end.north, end.east) - now.next()).norm();
    bid.value -= from_end;
    bid.why.push_back({"from_end", from_end});
  }
  // The way home is never refused: there is none cheaper.
  if (beyond_battery > 0.0 && !MayEndAnywhere(*prospect.option)) {
    bid.veto = "the battery does not reach home after it";
  }
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_ReturnHome);

}  // namespace limpet
