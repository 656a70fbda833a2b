// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

/// What is known of the first pose:  r = (x - mean) / sigma, in the order of NavVector.
/// The mean stays what it was given, wherever the pose is linearised.
class PosePriorFactor {
 public:
  static constexpr int kDim = 6;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  PosePriorFactor(const NavVector& mean, const NavVector& sigma)
      : mean_(mean), inv_sigma_(sigma.cwiseInverse()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    if (J != nullptr) {
      *J = inv_sigma_.asDiagonal();
    }
    Residual r = x - mean_;
    r(kNavYaw) = WrapAngle(r(kNavYaw));
    r(kNavRoll) = WrapAngle(r(kNavRoll));
    return r.cwiseProduct(inv_sigma_);
  }

 private:
  NavVector mean_, inv_sigma_;
};

}  // namespace limpet
