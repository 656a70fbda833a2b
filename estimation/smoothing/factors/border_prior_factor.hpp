// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

#include "limpet/core/require.hpp"

namespace limpet {

/// What was known beforehand of a variable of the border, x:  r = A (x - mean), with
/// A^T A = covariance^-1. For a landmark: where a former session saw it, in this session's frame,
/// the frames' offset in the covariance; for slow errors of a sensor: what its data sheet says.
class BorderPriorFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  /// REQUIRES: `covariance` (in squares of the variable's units) symmetric and positive definite.
  BorderPriorFactor(const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance) : mean_(mean) {
    const Eigen::LLT<Eigen::Matrix3d> llt(covariance);
    LIMPET_REQUIRE(llt.info() == Eigen::Success, "a covariance is positive definite");
    sqrt_information_ = llt.matrixL().solve(Eigen::Matrix3d::Identity());
  }

  [[nodiscard]] Residual Evaluate(const Eigen::Vector3d& x, BorderJacobian* J = nullptr) const {
    if (J != nullptr) {
      *J = sqrt_information_;
    }
    return sqrt_information_ * (x - mean_);
  }

 private:
  Eigen::Vector3d mean_;
  Eigen::Matrix3d sqrt_information_;
};

}  // namespace limpet
