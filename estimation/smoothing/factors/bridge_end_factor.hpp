// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/factors/bridged_step_factor.hpp"

namespace limpet {

/// The first velocities after a dropout, beside those that would still bridge it: what the bridge
/// was off at its end, ahead and abeam,
///   r = (BridgeErrorAhead(error, yaw) - (bridged - measured)) / sigma.
class BridgeEndFactor {
 public:
  static constexpr int kDim = 2;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  /// `off_H`: bridged less measured, ahead and abeam at the heading `yaw` [m/s]; `variance_H` of
  /// each.
  BridgeEndFactor(const Eigen::Vector2d& off_H, const Eigen::Vector2d& variance_H, double yaw)
      : off_H_(off_H), inv_sigma_H_(variance_H.cwiseSqrt().cwiseInverse()), yaw_(yaw) {}

  [[nodiscard]] Residual Evaluate(const Eigen::Vector3d& error, BorderJacobian* J = nullptr) const {
    if (J != nullptr) {
      const double c = std::cos(yaw_), s = std::sin(yaw_);
      *J << c, s, 1.0, -s, c, 0.0;
      *J = inv_sigma_H_.asDiagonal() * *J;
    }
    return (BridgeErrorAhead(error, yaw_) - off_H_).cwiseProduct(inv_sigma_H_);
  }

 private:
  Eigen::Vector2d off_H_, inv_sigma_H_;
  double yaw_;
};

}  // namespace limpet
