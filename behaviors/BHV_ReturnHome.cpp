// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ReturnHome.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

double DistanceHome(const Pose2& from, const Situation& now) {
  return std::hypot(from.north - now.home.north, from.east - now.home.east);
}

}  // namespace

void BHV_ReturnHome::Shape(const Situation& now, double, SearchGoals& goals) const {
  const bool is_near_the_limit =
      now.travelled + 1.2 * DistanceHome(now.pose, now) > 0.9 * params_.range.value();
  if (params_.when == "now" || is_near_the_limit) {
    goals.destinations.push_back({.north = now.home.north, .east = now.home.east});
  }
}

std::optional<Bid> BHV_ReturnHome::Value(const Prospect& prospect, const Situation& now) const {
  const double to_go = prospect.length() + DistanceHome(prospect.path().end(), now);
  if (params_.when == "now") {
    return Bid{.value = -to_go, .why = {{"to_go", to_go}}, .veto = {}};
  }
  const double overrun = std::max(0.0, now.travelled + to_go - params_.range.value());
  return Bid{
      .value = -params_.lateness_weight * overrun, .why = {{"overrun", overrun}}, .veto = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_ReturnHome);

}  // namespace limpet
