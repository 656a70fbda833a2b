// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "estimation/smoothing/jacobians.hpp"

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

/// Constant errors of the dead reckoning: (scale of the gyro, the DVL further ahead and to
/// starboard than its file says [m]).
using MountErrors = Eigen::Vector3d;

/// What a turn of `yaw` [rad] shows of a DVL that sits elsewhere: how far the body's origin then
/// moves, ahead and to starboard at first, per metre ahead and to starboard.
[[nodiscard]] inline Eigen::Matrix2d SwingOf(double yaw) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  Eigen::Matrix2d swing;
  swing << c - 1.0, -s, s, c - 1.0;
  return swing;
}

/// The motion less its constant errors.
[[nodiscard]] inline Eigen::Vector4d WithoutMountErrors(const Eigen::Vector4d& motion,
                                                        const MountErrors& errors) {
  Eigen::Vector4d without = motion;
  without.head<2>() -= SwingOf(motion.w()) * errors.tail<2>();
  without.w() -= errors.x() * motion.w();
  return without;
}

/// XyzYawFactor for sensors whose slow errors, and constant ones if asked for, are estimated with
/// the poses:
///   r = (Rz(yaw_i)^T (p_j - p_i), yaw_j - yaw_i) - motion without errors, over sigma.
class CalibratedStepFactor {
 public:
  static constexpr int kDim = 4;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;
  /// Derivatives by the two poses, and by slow errors and mount.
  using Jacobians = StepJacobians<kDim, 2>;

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
  [[nodiscard]] Residual Evaluate(const NavVector& x_i, const NavVector& x_j,
                                  const SlowErrors& errors, const MountErrors& mount,
                                  Jacobians* J = nullptr) const {
    const Eigen::Vector4d off = motion_ - WithoutMountErrors(motion_, mount);
    if (J == nullptr) {
      return Evaluate(x_i, x_j, errors) + off.cwiseProduct(inv_sigma_);
    }
    BorderJacobian& J_mount = J->border[1];
    J_mount.setZero();
    J_mount.topRightCorner<2, 2>() = inv_sigma_.head<2>().asDiagonal() * SwingOf(motion_.w());
    J_mount(3, 0) = inv_sigma_.w() * motion_.w();
    return Evaluate(x_i, x_j, errors, &J->previous, &J->pose, &J->border[0]) +
           off.cwiseProduct(inv_sigma_);
  }

 private:
  Eigen::Vector4d motion_, inv_sigma_;
  double duration_;
  XyzYawFactor step_;
};

}  // namespace limpet
