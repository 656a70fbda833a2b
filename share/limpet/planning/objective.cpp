// SPDX-License-Identifier: MIT
#include "limpet/planning/objective.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr double kTargetStep = 0.25;

}  // namespace

bool Target::IsSeenFrom(const Pose2& pose) const {
  const double dn = north - pose.north;
  const double de = east - pose.east;
  const double reach = window.half_along + window.half_across;  // beyond it nothing needs turning
  if (std::abs(dn) > reach || std::abs(de) > reach) {
    return false;
  }
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  return window.Contains(dn * c + de * s, -dn * s + de * c);
}

std::optional<double> FirstLook(const DubinsPath& path, const Target& target) {
  std::optional<double> first;
  path.Sample(kTargetStep, [&](const Pose2& pose, double s) {
    if (!first && target.IsSeenFrom(pose)) {
      first = s;
    }
  });
  return first;
}

double TargetValueOf(const DubinsPath& path, const Objective& objective) {
  double value = 0.0;
  for (const Target& target : objective.targets) {
    if (const std::optional<double> first = FirstLook(path, target)) {
      value += target.value * std::max(0.0, 1.0 - *first / objective.target_decay_m);
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
