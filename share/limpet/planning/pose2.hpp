// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "limpet/topics/mission.hpp"

namespace limpet {

/// A pose in the horizontal plane: NED [m], yaw clockwise from north [rad].
struct Pose2 {
  double north = 0.0;
  double east = 0.0;
  double yaw = 0.0;
};

/// Where `from` gets to along a segment. Exact; the yaw is not wrapped.
[[nodiscard]] inline Pose2 Advance(const Pose2& from, const PathSegment& segment) {
  const auto [curvature, length] = segment;
  const double half_turn = 0.5 * curvature * length;
  // sin(x)/x keeps a straight line and a shallow arc on one smooth formula.
  const double chord = std::abs(half_turn) < 1e-6 ? length * (1.0 - half_turn * half_turn / 6.0)
                                                  : length * std::sin(half_turn) / half_turn;
  return {.north = from.north + chord * std::cos(from.yaw + half_turn),
          .east = from.east + chord * std::sin(from.yaw + half_turn),
          .yaw = from.yaw + 2.0 * half_turn};
}

[[nodiscard]] inline double Distance(const Pose2& a, const Pose2& b) {
  return std::hypot(a.north - b.north, a.east - b.east);
}

}  // namespace limpet
