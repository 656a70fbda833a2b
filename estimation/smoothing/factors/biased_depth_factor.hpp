// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Depth of the body origin, with slow errors e [m] of how it is known:
///   r = (z + share . e - measured) / sigma.
/// A pressure sensor reads too deep by its bias; what floats does so too deep by an error of its
/// own.
class BiasedDepthFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  BiasedDepthFactor(Meters measured, Meters sigma, const Eigen::Vector3d& share)
      : measured_(measured.value()), inv_sigma_(1.0 / sigma.value()), share_(share) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& errors,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_errors = nullptr) const {
    if (J_pose != nullptr) {
      J_pose->setZero();
      (*J_pose)(kNavZ) = inv_sigma_;
    }
    if (J_errors != nullptr) *J_errors = inv_sigma_ * share_.transpose();
    return Residual((x(kNavZ) + share_.dot(errors) - measured_) * inv_sigma_);
  }

 private:
  double measured_, inv_sigma_;
  Eigen::Vector3d share_;
};

}  // namespace limpet
