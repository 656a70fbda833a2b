// SPDX-License-Identifier: MIT
#include "limpet/vehicle/thruster_layout.hpp"

#include <Eigen/Geometry>

namespace limpet {

Eigen::Matrix<double, 6, kThrusters> ThrusterLayout::WrenchPerThrust() const {
  Eigen::Matrix<double, 6, kThrusters> B;
  for (int i = 0; i < kThrusters; ++i) {
    const Thruster& thruster = thrusters[static_cast<std::size_t>(i)];
    B.col(i) << thruster.axis_B, thruster.p_B.cross(thruster.axis_B);
  }
  return B;
}

}  // namespace limpet
