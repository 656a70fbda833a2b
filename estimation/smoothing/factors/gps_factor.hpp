// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A GPS fix at the surface, horizontal:  r = (p_xy - measured) / sigma.
/// The error of fixes is correlated over about a minute; `WhiteSigma` says what each of a row of
/// fixes is worth if they are to be taken as independent.
class GpsFactor {
 public:
  static constexpr int kDim = 2;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  GpsFactor(const Eigen::Vector2d& measured, Meters sigma)
      : measured_(measured), inv_sigma_(1.0 / sigma.value()) {}

  /// sigma sqrt(correlation / interval), never below sigma.
  [[nodiscard]] static Meters WhiteSigma(Meters sigma, Seconds interval, Seconds correlation) {
    return sigma * std::sqrt(std::max(correlation / interval, 1.0));
  }

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    if (J != nullptr) {
      J->setZero();
      (*J)(0, kNavX) = inv_sigma_;
      (*J)(1, kNavY) = inv_sigma_;
    }
    return (x.head<2>() - measured_) * inv_sigma_;
  }

 private:
  Eigen::Vector2d measured_;
  double inv_sigma_;
};

}  // namespace limpet
