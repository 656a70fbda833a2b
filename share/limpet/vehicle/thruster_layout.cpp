// SPDX-License-Identifier: MIT
#include "limpet/vehicle/thruster_layout.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>

namespace limpet {
namespace {

bool AreIndependent(const Eigen::Matrix<double, 6, kThrusters>& wrenches,
                    const std::vector<int>& axes) {
  const Eigen::MatrixXd rows = wrenches(axes, Eigen::all);
  return rows.colPivHouseholderQr().rank() == rows.rows();
}

}  // namespace

std::vector<int> ThrusterLayout::ControlledAxes() const {
  const Eigen::Matrix<double, 6, kThrusters> wrenches = WrenchPerThrust();
  std::vector<int> axes{0, 1, 2, 4, 5};
  if (AreIndependent(wrenches, axes)) return axes;
  axes = {0, 1, 2, 5};
  return AreIndependent(wrenches, axes) ? axes : std::vector<int>{};
}

double ThrusterLayout::MostHeave() const {
  double share = 0.0;
  for (const Thruster& thruster : thrusters) {
    share += std::abs(thruster.axis_B.z());
  }
  return share * max_thrust_n;
}

Eigen::Matrix<double, 6, kThrusters> ThrusterLayout::WrenchPerThrust() const {
  Eigen::Matrix<double, 6, kThrusters> B;
  for (int i = 0; i < kThrusters; ++i) {
    const Thruster& thruster = thrusters[static_cast<std::size_t>(i)];
    B.col(i) << thruster.axis_B, thruster.p_B.cross(thruster.axis_B);
  }
  return B;
}

}  // namespace limpet
