// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// How a sensor stands on the vehicle, from how the vehicle's file says it does.
struct MountingErrorParams {
  Radians roll{0.0}, pitch{0.0}, yaw{0.0};
  Eigen::Vector3d off_B = Eigen::Vector3d::Zero();

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("roll_deg", roll, "Turned about the vehicle's forward axis",
          InRange(-20.0_deg, 20.0_deg));
    visit("pitch_deg", pitch, "Turned about the vehicle's starboard axis",
          InRange(-20.0_deg, 20.0_deg));
    visit("yaw_deg", yaw, "Turned about the vehicle's down axis", InRange(-20.0_deg, 20.0_deg));
    visit("off_m", off_B, "m", "It stands so far forward, starboard and down of where it should",
          InRange(-2.0, 2.0));
  }
  /// Body axes as the sensor should stand in, to those it stands in.
  [[nodiscard]] Eigen::Matrix3d rotation() const {
    return RotationFromRollPitchYaw(roll.value(), pitch.value(), yaw.value());
  }
  [[nodiscard]] CameraModel Applied(CameraModel camera) const {
    camera.R_BC = rotation() * camera.R_BC;
    camera.p_BC += off_B;
    return camera;
  }
};

}  // namespace limpet
