// SPDX-License-Identifier: MIT
#include "estimation/smoothing/camera_errors.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "limpet/core/cross_product.hpp"

namespace limpet {
namespace {

Eigen::Matrix3d Exp(const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle < 1e-12) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

/// Right Jacobian of Exp, for rotations of a few degrees: to third order.
Eigen::Matrix3d RightJacobian(const Eigen::Vector3d& rotation) {
  const Eigen::Matrix3d S = CrossMatrixOf(rotation);
  return Eigen::Matrix3d::Identity() - 0.5 * S + S * S / 6.0;
}

Eigen::Vector3d LeverOf(const CameraErrors& errors) {
  return {errors.lever_and_delay.x(), errors.lever_and_delay.y(), 0.0};
}

}  // namespace

CameraModel WithErrors(const CameraModel& camera, const CameraErrors& errors,
                       const BodyMotion& motion) {
  const double delay = errors.lever_and_delay.z();
  const Eigen::Matrix3d R_since = Exp(delay * motion.omega_B);
  CameraModel real = camera;
  real.R_BC = R_since.transpose() * Exp(errors.tilt_B) * camera.R_BC;
  real.p_BC = R_since.transpose() * (camera.p_BC + LeverOf(errors) - delay * motion.v_B);
  return real;
}

CameraErrorJacobians ErrorJacobiansOf(const CameraModel& camera, const CameraErrors& errors,
                                      const BodyMotion& motion, const Eigen::Vector3d& p_C) {
  const Eigen::Matrix3d R_CM = camera.R_BC.transpose() * Exp(-errors.tilt_B);
  const Eigen::Vector3d from_camera_B = R_CM.transpose() * p_C;
  const Eigen::Vector3d from_body_B =
      from_camera_B - errors.lever_and_delay.z() * motion.v_B + camera.p_BC + LeverOf(errors);
  CameraErrorJacobians J;
  J.J_tilt = R_CM * CrossMatrixOf(from_camera_B) * RightJacobian(-errors.tilt_B);
  J.J_shift.leftCols<2>() = -R_CM.leftCols<2>();
  J.J_shift.col(2) = R_CM * (motion.omega_B.cross(from_body_B) + motion.v_B);
  return J;
}

}  // namespace limpet
