// SPDX-License-Identifier: MIT
#include "limpet/control/thrust_allocation.hpp"

#include <algorithm>
#include <array>

#include <Eigen/LU>

#include "limpet/core/require.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {
namespace {

constexpr std::array kControlled = {kSurge, kSway, kHeave, kPitch, kYaw};

/// The largest share of `step`, at most 1, that keeps every thruster within `limit`.
double FeasibleShare(const ThrusterVector& thrust, const ThrusterVector& step, double limit) {
  double share = 1.0;
  for (int i = 0; i < kThrusters; ++i) {
    const double room = step(i) > 0.0 ? limit - thrust(i) : limit + thrust(i);
    const double need = std::abs(step(i));
    if (need > room) share = std::min(share, std::max(0.0, room) / need);
  }
  return share;
}

}  // namespace

ThrustAllocation::ThrustAllocation(const ThrusterLayout& layout, const ThrusterVector& price)
    : layout_(layout), wrench_per_thrust_(layout.WrenchPerThrust()) {
  LIMPET_REQUIRE((price.array() > 0.0).all(), "prices of thrusters are positive");
  constexpr int kRows = static_cast<int>(kControlled.size());
  Eigen::Matrix<double, kRows, kThrusters> B;
  for (int row = 0; row < kRows; ++row) {
    B.row(row) = wrench_per_thrust_.row(kControlled[static_cast<std::size_t>(row)]);
  }
  // Fossen 2011 eq. 12.276: W^-1 B' (B W^-1 B')^-1.
  const ThrusterVector cheapness = price.cwiseInverse();
  const Eigen::Matrix<double, kThrusters, kRows> weighted = cheapness.asDiagonal() * B.transpose();
  const Eigen::Matrix<double, kRows, kRows> gram = B * weighted;
  const Eigen::Matrix<double, kThrusters, kRows> inverse = weighted * gram.inverse();
  thrust_per_wrench_.setZero();
  for (int row = 0; row < kRows; ++row) {
    thrust_per_wrench_.col(kControlled[static_cast<std::size_t>(row)]) = inverse.col(row);
  }
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
