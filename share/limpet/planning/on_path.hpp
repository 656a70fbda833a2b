// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "limpet/planning/dubins_path.hpp"
#include "limpet/planning/pose2.hpp"

namespace limpet {

/// Whether a vehicle at `pose` is where `path` begins: then that path can be followed on.
[[nodiscard]] inline bool IsOnPath(const DubinsPath& path, const Pose2& pose) {
  constexpr double kOff_m = 0.05, kTurned_rad = 0.02;
  const double turned = path.start().yaw - pose.yaw;
  return Distance(path.start(), pose) < kOff_m &&
         std::abs(std::remainder(turned, 2.0 * std::numbers::pi)) < kTurned_rad;
}

}  // namespace limpet
