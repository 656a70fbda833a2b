// SPDX-License-Identifier: MIT
#include "limpet/vehicle/thruster_layout.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>

namespace limpet {
namespace {

/// Farther apart than this, two places are not each other's mirror image [m]; and two pushes,
/// as parts of one.
constexpr double kAside = 0.05, kAskew = 0.1;

bool AreIndependent(const ThrusterWrenches& wrenches, const std::vector<int>& axes) {
  const Eigen::MatrixXd rows = wrenches(axes, Eigen::all);
  return rows.colPivHouseholderQr().rank() == rows.rows();
}

}  // namespace

std::vector<int> ThrusterLayout::ControlledAxes() const {
  const ThrusterWrenches wrenches = WrenchPerThrust();
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

ThrusterWrenches ThrusterLayout::WrenchPerThrust() const {
  ThrusterWrenches B = ThrusterWrenches::Zero();
  int column = 0;
  for (const Thruster& thruster : thrusters)
    B.col(column++) << thruster.axis_B, thruster.p_B.cross(thruster.axis_B);
  return B;
}

std::optional<std::size_t> ThrusterLayout::Unpaired() const {
  const Eigen::Vector3d mirror(1.0, -1.0, 1.0);
  for (std::size_t i = 0; i < thrusters.size(); ++i) {
    const Eigen::Vector3d p_B = thrusters[i].p_B.cwiseProduct(mirror);
    const Eigen::Vector3d axis_B = thrusters[i].axis_B.cwiseProduct(mirror);
    // It pushes both ways: a push and its opposite are one.
    if (std::ranges::none_of(thrusters, [&](const Thruster& other) {
          return (other.p_B - p_B).norm() < kAside &&
                 std::min((other.axis_B - axis_B).norm(), (other.axis_B + axis_B).norm()) < kAskew;
        })) {
      return i;
    }
  }
  return std::nullopt;
}

bool ThrusterLayout::HeavesLevel() const {
  const ThrusterWrenches wrenches = WrenchPerThrust();
  const Wrench heave = Wrench::Unit(2);
  const ThrusterVector thrust = wrenches.completeOrthogonalDecomposition().solve(heave);
  constexpr double kPitched = 0.1;  // [N m] by 1 N: a hand's breadth off the middle
  return std::abs((wrenches * thrust - heave)(4)) < kPitched;
}

}  // namespace limpet
