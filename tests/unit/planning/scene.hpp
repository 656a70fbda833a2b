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

/// A basin with its region around it, and the way out round a quay's head by two places.
inline SurveyArea Basin() {
  SurveyArea basin{.north_min = -20, .north_max = 0, .east_min = -25, .east_max = 25};
  basin.outline = "{-25,-20:25,-20:25,0:-25,0}";
  basin.operating_region = "{-26.5,-21.5:27,-21.5:27,1.5:-26.5,1.5}";
  basin.transit = "{38,2:36,-10}";
  return basin;
}

inline Footprint TableFootprint() {
  return {{.altitude = kAltitude, .object_height_max = kArea.object_height_max}, CameraModel{}};
}

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
