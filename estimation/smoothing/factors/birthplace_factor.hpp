// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Holds a new landmark weakly where its first looks put it, as seen from the pose of the first:
///   r = ((p_W - p_WB) - offset) / sigma, per axis of W.
/// Relative to that pose, never to W: fifty landmarks held in W by 3 m each would be as good as a
/// GPS fix of 0.4 m that nobody took.
class BirthplaceFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  BirthplaceFactor(const Eigen::Vector3d& offset_W, Meters sigma)
      : offset_(offset_W), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p_W,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_landmark = nullptr) const {
    if (J_pose != nullptr) {
      J_pose->setZero();
      J_pose->leftCols<3>().diagonal().setConstant(-inv_sigma_);
    }
    if (J_landmark != nullptr) *J_landmark = inv_sigma_ * BorderJacobian::Identity();
    return inv_sigma_ * (p_W - x.head<3>() - offset_);
  }

 private:
  Eigen::Vector3d offset_;
  double inv_sigma_;
};

}  // namespace limpet
