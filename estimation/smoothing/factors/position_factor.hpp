// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

/// A place of the vehicle, as an acoustic positioning system finds it:
///   r = (p_WB - measured) / sigma, each axis with its own sigma.
class PositionFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  /// Both in W [m]; sigmas positive.
  PositionFactor(const Eigen::Vector3d& measured_W, const Eigen::Vector3d& sigma_W)
      : measured_W_(measured_W), inv_sigma_W_(sigma_W.cwiseInverse()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    if (J != nullptr) {
      J->setZero();
      J->leftCols<3>() = inv_sigma_W_.asDiagonal();
    }
    return (x.head<3>() - measured_W_).cwiseProduct(inv_sigma_W_);
  }

 private:
  Eigen::Vector3d measured_W_, inv_sigma_W_;
};

}  // namespace limpet
