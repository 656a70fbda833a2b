// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Roll and pitch of the attitude filter:  r = (roll - measured, pitch - measured) / sigma.
/// Valid away from pitch +-90 deg.
class RollPitchFactor {
 public:
  static constexpr int kDim = 2;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  RollPitchFactor(Radians roll, Radians pitch, Radians sigma)
      : measured_(roll.value(), pitch.value()), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    if (J != nullptr) {
      J->setZero();
      (*J)(0, kNavRoll) = inv_sigma_;
      (*J)(1, kNavPitch) = inv_sigma_;
    }
    return Residual(WrapAngle(x(kNavRoll) - measured_(0)), x(kNavPitch) - measured_(1)) *
           inv_sigma_;
  }

 private:
  Eigen::Vector2d measured_;
  double inv_sigma_;
};

}  // namespace limpet
