// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/camera_model.hpp"

namespace limpet {

/// Residual of what a camera cannot show from an estimate that is lost [px].
inline constexpr double kLost_px = 1000.0;

/// A landmark in the camera frame, with its derivatives by the body's pose and by the landmark.
struct CameraPoint {
  Eigen::Vector3d p_C;
  Eigen::Matrix<double, 3, 6> J_pose;
  Eigen::Matrix3d J_landmark;
};

/// p_C = R_CB (R_BW (p_W - p_WB) - p_BC).
[[nodiscard]] CameraPoint CameraPointOf(const CameraModel& camera, const NavVector& x,
                                        const Eigen::Vector3d& p_W);

}  // namespace limpet
