// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// How a body moves, in its own axes.
struct BodyMotion {
  Eigen::Vector3d v_B = Eigen::Vector3d::Zero();      ///< [m/s]
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();  ///< [rad/s]
};

}  // namespace limpet
