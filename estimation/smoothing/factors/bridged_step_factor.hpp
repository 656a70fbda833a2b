// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"

namespace limpet {

/// XyzYawFactor in a dropout of the velocity, which is bridged by a guess. What the guess is off
/// stays the same for long and is estimated: (ahead, abeam [m/s], nothing), in the levelled heading
/// frame of the earlier pose.
///   r = (Rz(yaw_i)^T (p_j - p_i) + error duration, yaw_j - yaw_i) - motion, over sigma.
class BridgedStepFactor {
 public:
  static constexpr int kDim = 4;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  BridgedStepFactor(const Eigen::Vector4d& motion, const Eigen::Vector4d& variance, double duration)
      : share_(duration * variance.head<2>().cwiseSqrt().cwiseInverse()), step_(motion, variance) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x_i, const NavVector& x_j,
                                  const Eigen::Vector3d& error, Jacobian* J_i = nullptr,
                                  Jacobian* J_j = nullptr,
                                  BorderJacobian* J_error = nullptr) const {
    if (J_error != nullptr) {
      J_error->setZero();
      J_error->topLeftCorner<2, 2>() = share_.asDiagonal();
    }
    Residual r = step_.Evaluate(x_i, x_j, J_i, J_j);
    r.head<2>() += share_.cwiseProduct(error.head<2>());
    return r;
  }

 private:
  Eigen::Vector2d share_;
  XyzYawFactor step_;
};

}  // namespace limpet
