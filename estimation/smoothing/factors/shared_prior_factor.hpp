// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include <Eigen/Core>

namespace limpet {

/// What is known beforehand of one of the three numbers of a border variable:
///   r = x_i / sigma.
/// Errors of one kind tell how large others of it may be, so sigma is shared, and read whenever the
/// factor is linearised.
class SharedPriorFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  SharedPriorFactor(int index, std::shared_ptr<const double> sigma)
      : index_(index), sigma_(std::move(sigma)) {}

  [[nodiscard]] Residual Evaluate(const Eigen::Vector3d& x, BorderJacobian* J = nullptr) const {
    const double inv_sigma = 1.0 / *sigma_;
    if (J != nullptr) {
      J->setZero();
      (*J)(index_) = inv_sigma;
    }
    return Residual(x(index_) * inv_sigma);
  }

 private:
  int index_;
  std::shared_ptr<const double> sigma_;
};

}  // namespace limpet
