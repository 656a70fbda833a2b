// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

/// A place of the vehicle, as an acoustic positioning system finds it that is off by the same in
/// all of its fixes, three slow errors:
///   r = (p_WB + off - measured) / sigma, each axis with its own sigma.
class PositionFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  /// Both in W [m]; sigmas positive.
  PositionFactor(const Eigen::Vector3d& measured_W, const Eigen::Vector3d& sigma_W)
      : measured_W_(measured_W), inv_sigma_W_(sigma_W.cwiseInverse()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& off_W,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_off = nullptr) const {
    if (J_pose != nullptr) {
      J_pose->setZero();
      J_pose->leftCols<3>() = inv_sigma_W_.asDiagonal();
    }
    if (J_off != nullptr) *J_off = inv_sigma_W_.asDiagonal();
    return (x.head<3>() + off_W - measured_W_).cwiseProduct(inv_sigma_W_);
  }

 private:
  Eigen::Vector3d measured_W_, inv_sigma_W_;
};

}  // namespace limpet
