// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Depth of the body origin from pressure:  r = (z - measured) / sigma.
class DepthFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  DepthFactor(Meters measured, Meters sigma)
      : measured_(measured.value()), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    if (J != nullptr) {
      J->setZero();
      (*J)(0, kNavZ) = inv_sigma_;
    }
    return Residual((x(kNavZ) - measured_) * inv_sigma_);
  }

 private:
  double measured_, inv_sigma_;
};

}  // namespace limpet
