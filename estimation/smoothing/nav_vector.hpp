// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/frames.hpp"

namespace limpet {

/// Pose of the body in W as the smoother's variable: x, y, z [m], yaw, pitch, roll [rad], in MRPT's
/// order, so that covariances pass through unchanged. Updates add; yaw is not wrapped.
using NavVector = Eigen::Matrix<double, 6, 1>;
using NavCovariance = Eigen::Matrix<double, 6, 6>;

enum NavIndex { kNavX = 0, kNavY = 1, kNavZ = 2, kNavYaw = 3, kNavPitch = 4, kNavRoll = 5 };

[[nodiscard]] inline Pose PoseOf(const NavVector& x) {
  return {x.head<3>(), x(kNavRoll), x(kNavPitch), WrapAngle(x(kNavYaw))};
}

}  // namespace limpet
