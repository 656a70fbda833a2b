// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "limpet/core/camera_geometry.hpp"

namespace limpet {

/// A rectified pinhole camera at any place and angle on the body. Camera frame C:
/// right-down-forward.
struct CameraModel {
  double width_px = 640.0, height_px = 480.0;
  double fx = 400.0, fy = 400.0, cx = 320.0, cy = 240.0;
  Eigen::Matrix3d R_BC = CameraGeometry::R_BC();
  Eigen::Vector3d p_BC = Eigen::Vector3d::Zero();

  [[nodiscard]] static CameraModel From(const CameraGeometry& camera) {
    return {.width_px = static_cast<double>(camera.width_px),
            .height_px = static_cast<double>(camera.height_px),
            .fx = camera.fx(),
            .fy = camera.fy(),
            .cx = camera.cx(),
            .cy = camera.cy(),
            .R_BC = CameraGeometry::R_BC(),
            .p_BC = camera.p_BC};
  }
};

}  // namespace limpet
