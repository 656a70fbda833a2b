// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/planning/pose2.hpp"
#include "limpet/planning/sight_along.hpp"

namespace limpet {

/// A place worth passing, e.g. an object of the former session.
struct Target {
  double north = 0.0, east = 0.0;  ///< [m]
  double radius = 1.5;             ///< seen when the vehicle has come this near [m]
  double value = 0.0;              ///< for seeing it now [m of path]
};

/// What a path is worth, in metres of path (paper.md section 5):
///   U = w_cover newArea / swath - w_frontier dFrontier - length + sum value_i (1 - s_i / decay).
struct Objective {
  double w_cover = 1.0;
  double w_frontier = 0.325;    ///< best in the study with kBottomTwice
  std::vector<Target> targets;  ///< at most kMaxTargets are looked at, most valuable first
  double target_decay_m = 100.0;
  static constexpr int kMaxTargets = 32;
};

/// The objective of a whole path from the present ground.
[[nodiscard]] double ValueOf(const DubinsPath& path, const Objective& objective,
                             const Ground& ground, SightAlong& sight);
/// The targets' part alone: sum of value_i (1 - s_i / decay), s_i where the path first comes within
/// its radius.
[[nodiscard]] double TargetValueOf(const DubinsPath& path, const Objective& objective);

}  // namespace limpet
