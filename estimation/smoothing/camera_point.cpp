// SPDX-License-Identifier: MIT
#include "estimation/smoothing/camera_point.hpp"

#include <cmath>

namespace limpet {

CameraPoint CameraPointOf(const CameraModel& camera, const NavVector& x,
                          const Eigen::Vector3d& p_W) {
  const double cy = std::cos(x(kNavYaw)), sy = std::sin(x(kNavYaw));
  const double cp = std::cos(x(kNavPitch)), sp = std::sin(x(kNavPitch));
  const double cr = std::cos(x(kNavRoll)), sr = std::sin(x(kNavRoll));
  Eigen::Matrix3d unyaw, unroll, unpitch;  // Rz^T, Rx^T and Ry^T
  unyaw << cy, sy, 0.0, -sy, cy, 0.0, 0.0, 0.0, 1.0;
  unroll << 1.0, 0.0, 0.0, 0.0, cr, sr, 0.0, -sr, cr;
  unpitch << cp, 0.0, -sp, 0.0, 1.0, 0.0, sp, 0.0, cp;

  const Eigen::Matrix3d R_BW = unroll * unpitch * unyaw;

  const Eigen::Vector3d d = p_W - x.head<3>();
  const Eigen::Vector3d a(cy * d.x() + sy * d.y(), -sy * d.x() + cy * d.y(), d.z());
  const Eigen::Vector3d b = unpitch * a;
  const Eigen::Vector3d q = unroll * b;
  // Each rotation's derivative turns what comes before it by a quarter.
  Eigen::Matrix<double, 3, 6> J_B;
  J_B.leftCols<3>() = -R_BW;
  J_B.col(kNavYaw) = unroll * (unpitch * Eigen::Vector3d(a.y(), -a.x(), 0.0));
  J_B.col(kNavPitch) = unroll * Eigen::Vector3d(-b.z(), 0.0, b.x());
  J_B.col(kNavRoll) = Eigen::Vector3d(0.0, q.z(), -q.y());

  const Eigen::Matrix3d R_CB = camera.R_BC.transpose();
  return {.p_C = R_CB * (q - camera.p_BC), .J_pose = R_CB * J_B, .J_landmark = R_CB * R_BW};
}

}  // namespace limpet
