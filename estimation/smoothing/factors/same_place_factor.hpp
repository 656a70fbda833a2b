// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

/// Two landmarks are one:  r = (a_W - b_W) / sigma. Small `sigma`, not none, so that it can be
/// taken back, and what the places say without it be told from what they say with it.
class SamePlaceFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  explicit SamePlaceFactor(Meters sigma) : inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const Eigen::Vector3d& a_W, const Eigen::Vector3d& b_W,
                                  BorderJacobian* J_a = nullptr,
                                  BorderJacobian* J_b = nullptr) const {
    if (J_a != nullptr) *J_a = inv_sigma_ * BorderJacobian::Identity();
    if (J_b != nullptr) *J_b = -inv_sigma_ * BorderJacobian::Identity();
    return inv_sigma_ * (a_W - b_W);
  }

 private:
  double inv_sigma_;
};

}  // namespace limpet
