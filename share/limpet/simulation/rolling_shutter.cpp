// SPDX-License-Identifier: MIT
#include "limpet/simulation/rolling_shutter.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace limpet {

Eigen::Vector3d SeenRowByRow(const RollingShutterParams& shutter, const CameraModel& camera,
                             const Pose& X_WB, const BodyMotion& motion,
                             const Eigen::Vector3d& p_W) {
  if (shutter.readout <= Seconds(0.0)) return p_W;
  const Eigen::Matrix3d R_WB = RotationOf(X_WB);
  Eigen::Vector3d seen_W = p_W;
  // The row tells the time and the time the row: rows pass faster than points move.
  for (int i = 0; i < 3; ++i) {
    const auto pixel = camera.Project(camera.InCamera(X_WB, seen_W));
    if (!pixel) return p_W;
    const double row = std::clamp(pixel->y() / camera.height_px, 0.0, 1.0);
    const double dt = row * shutter.readout.value();
    const Eigen::Vector3d turn = motion.omega_B * dt;
    const double angle = turn.norm();
    const Eigen::Matrix3d R_WB_then =
        angle > 0.0 ? Eigen::Matrix3d(R_WB * Eigen::AngleAxisd(angle, turn / angle)) : R_WB;
    const Eigen::Vector3d p_B =
        R_WB_then.transpose() * (p_W - X_WB.p_WB - dt * (R_WB * motion.v_B));
    seen_W = X_WB.p_WB + R_WB * p_B;
  }
  return seen_W;
}

}  // namespace limpet
