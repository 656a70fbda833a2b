// SPDX-License-Identifier: MIT
#include "limpet/planning/objective.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr double kTargetStep = 0.25;

}  // namespace

double TargetValueOf(const DubinsPath& path, const Objective& objective) {
  double value = 0.0;
  for (const Target& target : objective.targets) {
    double first = -1.0;
    path.Sample(kTargetStep, [&](const Pose2& pose, double s) {
      if (first < 0.0 &&
          std::hypot(pose.north - target.north, pose.east - target.east) <= target.radius) {
        first = s;
      }
    });
    if (first >= 0.0) {
      value += target.value * std::max(0.0, 1.0 - first / objective.target_decay_m);
    }
  }
  return value;
}

double ValueOf(const DubinsPath& path, const Objective& objective, const Ground& ground,
               SightAlong& sight) {
  const NewSight gain = sight(path);
  return objective.w_cover * gain.new_area / ground.swath() -
         objective.w_frontier * gain.frontier_growth - path.length() +
         TargetValueOf(path, objective);
}

}  // namespace limpet
