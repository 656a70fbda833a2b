// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Distance of the body origin from a landmark, as of an acoustic or radio beacon:
///   r = (|p_W - p_WB| - measured) / sigma.
/// Says nothing of the direction: where both coincide the derivative is zero.
class DistanceFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  DistanceFactor(Meters measured, Meters sigma)
      : measured_(measured.value()), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p_W,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_landmark = nullptr) const {
    const Eigen::Vector3d d = p_W - x.head<3>();
    const double distance = d.norm();
    const BorderJacobian J = inv_sigma_ / std::max(distance, kNearest) * d.transpose();
    if (J_pose != nullptr) *J_pose << -J, 0.0, 0.0, 0.0;
    if (J_landmark != nullptr) *J_landmark = J;
    return Residual((distance - measured_) * inv_sigma_);
  }

 private:
  static constexpr double kNearest = 1e-6;  ///< [m]
  double measured_, inv_sigma_;
};

}  // namespace limpet
