// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"

namespace limpet {

/// What a bridge over a dropout is off, (current north, current east, speed ahead) [m/s], as a
/// velocity ahead and abeam at a heading `yaw`.
[[nodiscard]] inline Eigen::Vector2d BridgeErrorAhead(const Eigen::Vector3d& error, double yaw) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  return {c * error.x() + s * error.y() + error.z(), c * error.y() - s * error.x()};
}

/// XyzYawFactor in a dropout of the velocity, which is bridged by a model of the water. What that
/// is off stays the same for long and is estimated: two parts that do not turn with the vehicle and
/// one that does.
///   r = (Rz(yaw_i)^T (p_j - p_i + (north, east) duration) + (ahead, 0) duration, yaw_j - yaw_i)
///       - motion, over sigma.
class BridgedStepFactor {
 public:
  static constexpr int kDim = 4;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  BridgedStepFactor(const Eigen::Vector4d& motion, const Eigen::Vector4d& variance, double duration)
      : duration_(duration), share_(duration / std::sqrt(variance(0))), step_(motion, variance) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x_i, const NavVector& x_j,
                                  const Eigen::Vector3d& error, Jacobian* J_i = nullptr,
                                  Jacobian* J_j = nullptr,
                                  BorderJacobian* J_error = nullptr) const {
    NavVector shifted = x_j;
    shifted.head<2>() += duration_ * error.head<2>();
    Jacobian J_shifted;
    Residual r = step_.Evaluate(x_i, shifted, J_i, &J_shifted);
    r(0) += share_ * error.z();
    if (J_j != nullptr) *J_j = J_shifted;
    if (J_error != nullptr) {
      J_error->leftCols<2>() = duration_ * J_shifted.leftCols<2>();
      J_error->col(2) << share_, 0.0, 0.0, 0.0;
    }
    return r;
  }

 private:
  double duration_, share_;
  XyzYawFactor step_;
};

}  // namespace limpet
