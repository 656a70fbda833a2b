// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// An object stands on the seabed or floats a little above it:
///   r = ((z_object - z_body) - (altitude - height)) / sigma.
/// Weak, and relative to the pose that measured the altitude, so that the pose's own error is not
/// taken for knowledge. Gives a new landmark a range until parallax does.
class SeabedFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  SeabedFactor(Meters altitude, Meters height, Meters sigma)
      : below_((altitude - height).value()), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p_W,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_landmark = nullptr) const {
    if (J_pose != nullptr) {
      J_pose->setZero();
      (*J_pose)(0, kNavZ) = -inv_sigma_;
    }
    if (J_landmark != nullptr) *J_landmark << 0.0, 0.0, inv_sigma_;
    return Residual((p_W.z() - x(kNavZ) - below_) * inv_sigma_);
  }

 private:
  double below_, inv_sigma_;
};

}  // namespace limpet
