// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/planning/pose2.hpp"
#include "limpet/planning/sight_along.hpp"
#include "limpet/survey/look.hpp"

namespace limpet {

/// A place worth looking at, e.g. an object of the former session.
struct Target {
  double north = 0.0, east = 0.0;  ///< [m]
  LookWindow window{};             ///< where it must lie below the vehicle
  double value = 0.0;              ///< for seeing it now [m of path]
  /// Whether the vehicle at `pose` and survey altitude looks at it.
  [[nodiscard]] bool IsSeenFrom(const Pose2& pose) const;
};

/// What a path is worth, in metres of path (paper.md section 5):
///   U = w_cover newArea / swath - w_frontier dFrontier - length + sum value_i (1 - s_i / decay).
struct Objective {
  double w_cover = 1.0;
  double w_frontier = 0.325;  ///< best in the study with kBottomTwice
  std::vector<Target> targets;
  double target_decay_m = 100.0;
};

/// The objective of a whole path from the present ground.
[[nodiscard]] double ValueOf(const DubinsPath& path, const Objective& objective,
                             const Ground& ground, SightAlong& sight);
/// The targets' part alone: sum of value_i (1 - s_i / decay), s_i where the path first looks at it.
[[nodiscard]] double TargetValueOf(const DubinsPath& path, const Objective& objective);
/// Length of `path` at which it first looks at `target` [m]; nothing if it never does.
[[nodiscard]] std::optional<double> FirstLook(const DubinsPath& path, const Target& target);

}  // namespace limpet
