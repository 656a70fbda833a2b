// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A pinhole camera without distortion, anywhere on the body: the one camera of renderer, detector,
/// map, planner and smoother. Camera frame C: right-down-forward, i.e. image u grows to the right,
/// v downwards, z along the optical axis. As made, it looks straight down from the body's origin,
/// so that u grows to starboard and v aft. What lies between a direction and its pixel is in
/// Project and RayOf alone.
struct CameraModel {
  int width_px = 640;
  int height_px = 480;
  double fx = FocalLength(width_px, RadiansFromDegrees(80.0));   ///< [px]
  double fy = FocalLength(height_px, RadiansFromDegrees(60.0));  ///< [px]
  double cx = 0.5 * width_px, cy = 0.5 * height_px;              ///< pixel of the optical axis
  Eigen::Matrix3d R_BC = LookingDown();
  Eigen::Vector3d p_BC = Eigen::Vector3d::Zero();  ///< lever arm in the body frame [m]

  /// Full angles over the image's width and height [rad].
  struct FieldOfView {
    double across = 0.0, along = 0.0;
  };
  /// Model of an image whose middle is the optical axis.
  [[nodiscard]] static CameraModel FromFieldOfView(int width_px, int height_px,
                                                   const FieldOfView& field) {
    CameraModel camera;
    camera.width_px = width_px;
    camera.height_px = height_px;
    camera.fx = FocalLength(width_px, field.across);
    camera.fy = FocalLength(height_px, field.along);
    camera.cx = 0.5 * width_px;
    camera.cy = 0.5 * height_px;
    return camera;
  }
  /// Body from camera: x_C (right) = y_B, y_C (down in the image) = -x_B, z_C = z_B.
  [[nodiscard]] static Eigen::Matrix3d LookingDown() {
    Eigen::Matrix3d R;
    R << 0.0, -1.0, 0.0,  //
        1.0, 0.0, 0.0,    //
        0.0, 0.0, 1.0;
    return R;
  }

  /// Half the image's width and height, at unit depth.
  [[nodiscard]] double half_across() const { return 0.5 * width_px / fx; }
  [[nodiscard]] double half_along() const { return 0.5 * height_px / fy; }
  /// Full angles over the image's width and height [rad].
  [[nodiscard]] double fov_across() const { return 2.0 * std::atan(half_across()); }
  [[nodiscard]] double fov_along() const { return 2.0 * std::atan(half_along()); }

  /// A world point in camera coordinates [m].
  [[nodiscard]] Eigen::Vector3d InCamera(const Pose& X_WB, const Eigen::Vector3d& p_W) const {
    return R_BC.transpose() * (RotationOf(X_WB).transpose() * (p_W - X_WB.p_WB) - p_BC);
  }
  /// Pixel of a camera point, or nothing behind the camera.
  [[nodiscard]] std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C) const {
    if (p_C.z() < 1e-3) {
      return std::nullopt;
    }
    return Eigen::Vector2d(cx + fx * p_C.x() / p_C.z(), cy + fy * p_C.y() / p_C.z());
  }
  /// Unit vector in C towards what a pixel shows.
  [[nodiscard]] Eigen::Vector3d RayOf(const Eigen::Vector2d& at_px) const {
    return Eigen::Vector3d((at_px.x() - cx) / fx, (at_px.y() - cy) / fy, 1.0).normalized();
  }

 private:
  [[nodiscard]] static double FocalLength(int size_px, double angle) {
    return 0.5 * size_px / std::tan(0.5 * angle);
  }
};

}  // namespace limpet
