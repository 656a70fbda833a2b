// SPDX-License-Identifier: MIT
#include "limpet/planning/objective.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr double kTargetStep = 0.25;

/// What behaviors add, step by step.
double TermValueOf(const DubinsPath& path, const Objective& objective, SeenAlong& seen) {
  double value = 0.0;
  for (const auto& term : objective.terms) {
    PathEvents all(term->event_count());
    TermEvents events(all, 0);
    seen.EachStep(path, [&](const Pose2& from, const PathSegment& motion, double before,
                            const NewlySeen& step) {
      value +=
          term->Worth({.from = from, .motion = motion, .before = before, .seen = step}, events);
    });
  }
  return value;
}

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
  return window.Contains({dn * c + de * s, -dn * s + de * c});
}

double Target::WorthAt(double s, Meters decay) const {
  return value * std::max(0.0, 1.0 - s / decay.value());
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
      value += target.WorthAt(*first, Meters(objective.target_decay_m));
    }
  }
  return value;
}

double ValueOf(const DubinsPath& path, const Objective& objective, const Ground& ground,
               SeenAlong& seen) {
  const GroundWorth worth = objective.ground.Of(seen(path), ground.swath());
  return worth.useful - worth.ragged - path.length() + TargetValueOf(path, objective) +
         TermValueOf(path, objective, seen);
}

}  // namespace limpet
