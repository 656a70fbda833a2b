// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"

namespace limpet {

/// Slow errors of the dead reckoning: (scale of the DVL's velocity, its misalignment about the
/// body's z axis [rad], bias of the yaw rate [rad/s]).
using SlowErrors = Eigen::Vector3d;

/// A dead-reckoned motion (x, y, z [m], yaw [rad]) over `duration` [s], less its slow errors; to
/// first order, they are a few thousandths.
[[nodiscard]] inline Eigen::Vector4d WithoutSlowErrors(const Eigen::Vector4d& motion,
                                                       double duration, const SlowErrors& errors) {
  const double scale = errors.x(), turn = errors.y();
  return motion - Eigen::Vector4d(scale * motion.x() - turn * motion.y(),
                                  scale * motion.y() + turn * motion.x(), 0.0,
                                  errors.z() * duration);
}

/// XyzYawFactor for sensors whose slow errors are estimated with the poses:
///   r = (Rz(yaw_i)^T (p_j - p_i), yaw_j - yaw_i) - motion without errors, over sigma.
class CalibratedStepFactor {
 public:
  static constexpr int kDim = 4;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  CalibratedStepFactor(const Eigen::Vector4d& motion, const Eigen::Vector4d& variance,
                       double duration)
      : motion_(motion),
        inv_sigma_(variance.cwiseSqrt().cwiseInverse()),
        duration_(duration),
        step_(motion, variance) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x_i, const NavVector& x_j,
                                  const SlowErrors& errors, Jacobian* J_i = nullptr,
                                  Jacobian* J_j = nullptr,
                                  BorderJacobian* J_errors = nullptr) const {
    if (J_errors != nullptr) {
      *J_errors << motion_.x(), -motion_.y(), 0.0,  //
          motion_.y(), motion_.x(), 0.0,            //
          0.0, 0.0, 0.0,                            //
          0.0, 0.0, duration_;
      *J_errors = (inv_sigma_.asDiagonal() * *J_errors).eval();
    }
    const Eigen::Vector4d corrected = WithoutSlowErrors(motion_, duration_, errors);
    return step_.Evaluate(x_i, x_j, J_i, J_j) + (motion_ - corrected).cwiseProduct(inv_sigma_);
  }

 private:
  Eigen::Vector4d motion_, inv_sigma_;
  double duration_;
  XyzYawFactor step_;
};

}  // namespace limpet
