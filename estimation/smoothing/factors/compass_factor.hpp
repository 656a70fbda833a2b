// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A magnetic heading with the deviation that the vehicle's own iron gives it, three slow errors
/// (a, b, c) [rad]:  r = (measured - yaw - a - b sin(yaw) - c cos(yaw)) / sigma.
/// That is the compass adjuster's A, B and C; D and E, of the quarter circle, are left out.
class CompassFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  CompassFactor(Radians measured, Radians sigma)
      : measured_(measured.value()), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& deviation,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_deviation = nullptr) const {
    const double s = std::sin(x(kNavYaw)), c = std::cos(x(kNavYaw));
    if (J_pose != nullptr) {
      J_pose->setZero();
      (*J_pose)(kNavYaw) = -inv_sigma_ * (1.0 + deviation.y() * c - deviation.z() * s);
    }
    if (J_deviation != nullptr) *J_deviation = -inv_sigma_ * Eigen::RowVector3d(1.0, s, c);
    const double off = deviation.x() + deviation.y() * s + deviation.z() * c;
    return Residual(WrapAngle(measured_ - x(kNavYaw) - off) * inv_sigma_);
  }

 private:
  double measured_, inv_sigma_;
};

}  // namespace limpet
