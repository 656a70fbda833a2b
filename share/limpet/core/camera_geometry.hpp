// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A rectified pinhole camera that looks straight down from the body.
/// Camera frame C: right-down-forward, i.e. image u grows to starboard, image v grows aft, depth
/// along body down.
struct CameraGeometry {
  int width_px = 640;
  int height_px = 480;
  double fov_across = RadiansFromDegrees(80.0);    ///< full angle over the image's width [rad]
  double fov_along = RadiansFromDegrees(60.0);     ///< full angle over the image's height [rad]
  Eigen::Vector3d p_BC = Eigen::Vector3d::Zero();  ///< lever arm in the body frame [m]

  [[nodiscard]] double fx() const { return 0.5 * width_px / std::tan(0.5 * fov_across); }
  [[nodiscard]] double fy() const { return 0.5 * height_px / std::tan(0.5 * fov_along); }
  [[nodiscard]] double cx() const { return 0.5 * width_px; }
  [[nodiscard]] double cy() const { return 0.5 * height_px; }

  /// Body from camera: x_C (right) = y_B, y_C (down in the image) = -x_B, z_C (optical axis) = z_B.
  [[nodiscard]] static Eigen::Matrix3d R_BC() {
    Eigen::Matrix3d R;
    R << 0.0, -1.0, 0.0,  //
        1.0, 0.0, 0.0,    //
        0.0, 0.0, 1.0;
    return R;
  }
  /// A world point in camera coordinates [m].
  [[nodiscard]] Eigen::Vector3d InCamera(const Pose& X_WB, const Eigen::Vector3d& p_W) const {
    return R_BC().transpose() * (RotationOf(X_WB).transpose() * (p_W - X_WB.p_WB) - p_BC);
  }
  /// Pixel of a camera point, or nothing behind the camera.
  [[nodiscard]] std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C) const {
    if (p_C.z() < 1e-3) {
      return std::nullopt;
    }
    return Eigen::Vector2d(cx() + fx() * p_C.x() / p_C.z(), cy() + fy() * p_C.y() / p_C.z());
  }
};

}  // namespace limpet
