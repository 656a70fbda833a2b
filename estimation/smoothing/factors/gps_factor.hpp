// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A GPS fix at the surface, horizontal:  r = (p_xy - measured_W) / sigma.
/// The error of fixes wanders over minutes: what each of a row is worth, FixRow says.
class GpsFactor {
 public:
  static constexpr int kDim = 2;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  GpsFactor(const Eigen::Vector2d& measured_W, Meters sigma)
      : measured_W_(measured_W), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    if (J != nullptr) {
      J->setZero();
      (*J)(0, kNavX) = inv_sigma_;
      (*J)(1, kNavY) = inv_sigma_;
    }
    return (x.head<2>() - measured_W_) * inv_sigma_;
  }

 private:
  Eigen::Vector2d measured_W_;
  double inv_sigma_;
};

}  // namespace limpet
