// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include <Eigen/Core>

namespace limpet {

/// What is known of one of three sizes before it is seen:
///   r = log_size / sigma, the natural logarithm of its share of what is believed of it.
/// Sizes seen tell how much others differ, so sigma is shared, and read whenever the factor is
/// linearised.
class SizePriorFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  SizePriorFactor(int index, std::shared_ptr<const double> sigma)
      : index_(index), sigma_(std::move(sigma)) {}

  [[nodiscard]] Residual Evaluate(const Eigen::Vector3d& log_sizes,
                                  BorderJacobian* J = nullptr) const {
    const double inv_sigma = 1.0 / *sigma_;
    if (J != nullptr) {
      J->setZero();
      (*J)(index_) = inv_sigma;
    }
    return Residual(log_sizes(index_) * inv_sigma);
  }

 private:
  int index_;
  std::shared_ptr<const double> sigma_;
};

}  // namespace limpet
