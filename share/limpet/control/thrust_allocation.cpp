// SPDX-License-Identifier: MIT
#include "limpet/control/thrust_allocation.hpp"

#include <algorithm>
#include <vector>

#include <Eigen/LU>

#include "limpet/core/require.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {
namespace {

/// The largest share of `step`, at most 1, that keeps every thruster within `limit`.
double FeasibleShare(const ThrusterVector& thrust, const ThrusterVector& step, double limit) {
  double share = 1.0;
  for (int i = 0; i < kMostThrusters; ++i) {
    const double room = step(i) > 0.0 ? limit - thrust(i) : limit + thrust(i);
    const double need = std::abs(step(i));
    if (need > room) share = std::min(share, std::max(0.0, room) / need);
  }
  return share;
}

/// Thrusts per unit of each of the axes, the others of them zero: Fossen 2011 eq. 12.276,
/// W^-1 B' (B W^-1 B')^-1.
template <int kAxes>
Eigen::MatrixXd ThrustFor(const ThrusterWrenches& wrench_per_thrust, const std::vector<int>& axes,
                          const ThrusterVector& cheapness) {
  const Eigen::Matrix<double, kAxes, kMostThrusters> B = wrench_per_thrust(axes, Eigen::all);
  const Eigen::Matrix<double, kMostThrusters, kAxes> weighted =
      cheapness.asDiagonal() * B.transpose();
  const Eigen::Matrix<double, kAxes, kAxes> gram = B * weighted;
  return weighted * gram.inverse();
}

}  // namespace

ThrustAllocation::ThrustAllocation(const ThrusterLayout& layout, const ThrusterVector& price)
    : layout_(layout), wrench_per_thrust_(layout.WrenchPerThrust()) {
  LIMPET_REQUIRE((price.array() > 0.0).all(), "prices of thrusters are positive");
  const std::vector<int> axes = layout.ControlledAxes();
  LIMPET_REQUIRE(!axes.empty(), "thrusters push ahead, aside and down, and turn");
  const ThrusterVector cheapness = price.cwiseInverse();
  thrust_per_wrench_.setZero();
  thrust_per_wrench_(Eigen::all, axes) = axes.size() == 5
                                             ? ThrustFor<5>(wrench_per_thrust_, axes, cheapness)
                                             : ThrustFor<4>(wrench_per_thrust_, axes, cheapness);
}

ThrustAllocation::Result ThrustAllocation::Allocate(const Wrench& wanted) const {
  ThrusterVector thrust = ThrusterVector::Zero();
  bool is_saturated = false;
  const auto serve = [&](const ThrusterVector& step) {
    const double share = FeasibleShare(thrust, step, layout_.max_thrust_n);
    thrust += share * step;
    is_saturated = is_saturated || share < 1.0;
  };
  const auto of = [&](int axis) -> ThrusterVector {
    return thrust_per_wrench_.col(axis) * wanted(axis);
  };
  serve(of(kYaw));
  serve(of(kHeave));
  serve(of(kPitch));
  serve(of(kSurge) + of(kSway));
  return {.command = thrust / layout_.max_thrust_n,
          .achieved = wrench_per_thrust_ * thrust,
          .is_saturated = is_saturated};
}

}  // namespace limpet
