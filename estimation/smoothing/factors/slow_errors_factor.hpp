// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// How slow errors go on from one stretch of time to the next:  r = (b - keep a) / sigma, per
/// error; a first-order Gauss-Markov process in steps.
class SlowErrorsFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  SlowErrorsFactor(const Eigen::Vector3d& keep, const Eigen::Vector3d& sigma)
      : keep_(keep), inv_sigma_(sigma.cwiseInverse()) {}

  [[nodiscard]] Residual Evaluate(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  BorderJacobian* J_a = nullptr,
                                  BorderJacobian* J_b = nullptr) const {
    if (J_a != nullptr) *J_a = (-keep_.cwiseProduct(inv_sigma_)).asDiagonal();
    if (J_b != nullptr) *J_b = inv_sigma_.asDiagonal();
    return (b - keep_.cwiseProduct(a)).cwiseProduct(inv_sigma_);
  }

 private:
  Eigen::Vector3d keep_, inv_sigma_;
};

}  // namespace limpet
