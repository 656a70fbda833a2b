// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// One inertial sample, body FRD: specific force [m/s^2], rates [rad/s], heading [rad, true north].
struct InertialInput {
  double t = 0.0;
  Eigen::Vector3d force_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d rate_B = Eigen::Vector3d::Zero();
  double heading = 0.0;
};

}  // namespace limpet
