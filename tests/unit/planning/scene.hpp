// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/planning/dubins_path.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/survey/survey_grid.hpp"

namespace limpet::scene {

/// Table 1's area and camera.
inline const SurveyArea kArea{-15.0, 15.0, -18.0, 18.0, 2.0, 2.0};
inline constexpr double kAltitude = 4.0;
inline constexpr double kSeabedDown = 7.5;
inline constexpr Meters kRadius{3.0};

inline Footprint TableFootprint() { return {kAltitude, kArea.object_height_max, CameraModel{}}; }

inline Pose At(const Pose2& pose) {
  Pose X_WB;
  X_WB.p_WB = {pose.north, pose.east, kSeabedDown - kAltitude};
  X_WB.yaw = pose.yaw;
  return X_WB;
}

/// Flies `path` over `grid` with an image every 0.125 m.
inline void Fly(SurveyGrid& grid, const DubinsPath& path) {
  path.Sample(0.125, [&grid](const Pose2& pose, double) {
    grid.Observe(At(pose), kAltitude, CameraModel{});
  });
}

}  // namespace limpet::scene
