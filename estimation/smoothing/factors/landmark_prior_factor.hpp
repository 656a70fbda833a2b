// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

#include "limpet/core/require.hpp"

namespace limpet {

/// Where a former session saw an object, in this session's frame:  r = A (p - mean), with
/// A^T A = covariance^-1. The covariance holds the former session's and that of the frames' offset.
class LandmarkPriorFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  /// REQUIRES: `covariance` [m^2] symmetric and positive definite.
  LandmarkPriorFactor(const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance)
      : mean_(mean) {
    const Eigen::LLT<Eigen::Matrix3d> llt(covariance);
    LIMPET_REQUIRE(llt.info() == Eigen::Success, "a covariance is positive definite");
    sqrt_information_ = llt.matrixL().solve(Eigen::Matrix3d::Identity());
  }

  [[nodiscard]] Residual Evaluate(const Eigen::Vector3d& p, BorderJacobian* J = nullptr) const {
    if (J != nullptr) {
      *J = sqrt_information_;
    }
    return sqrt_information_ * (p - mean_);
  }

 private:
  Eigen::Vector3d mean_;
  Eigen::Matrix3d sqrt_information_;
};

}  // namespace limpet
