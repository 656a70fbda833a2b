// SPDX-License-Identifier: MIT
// What a camera's extrinsics and clock are off, and what follows for a point that it sees.
#pragma once

#include <Eigen/Core>

#include "limpet/core/body_motion.hpp"
#include "limpet/core/camera_model.hpp"

namespace limpet {

/// Slow errors of a camera, two border variables of the smoother.
struct CameraErrors {
  /// Rotation of the camera on the body beyond what its model says, about the body's axes (roll,
  /// pitch, yaw) [rad].
  Eigen::Vector3d tilt_B = Eigen::Vector3d::Zero();
  /// It sits further ahead and to starboard [m], and its stamps are late [s].
  Eigen::Vector3d lever_and_delay = Eigen::Vector3d::Zero();
};

/// The camera on a body with the pose of the stamp, from which the image looks as it does:
///   p_C = R_CB Exp(-tilt) (Exp(delay omega) q + delay v - p_BC - lever),  q the point in the body.
[[nodiscard]] CameraModel WithErrors(const CameraModel& camera, const CameraErrors& errors,
                                     const BodyMotion& motion);

/// How a point in the camera's frame follows the errors.
struct CameraErrorJacobians {
  Eigen::Matrix3d J_tilt, J_shift;
};
/// `camera`: without the errors; `p_C`: with them.
[[nodiscard]] CameraErrorJacobians ErrorJacobiansOf(const CameraModel& camera,
                                                    const CameraErrors& errors,
                                                    const BodyMotion& motion,
                                                    const Eigen::Vector3d& p_C);

}  // namespace limpet
