// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

/// Dead-reckoned displacement between two poses, in the levelled heading frame of the earlier one:
///   r = (Rz(yaw_i)^T (p_j - p_i) - moved, yaw_j - yaw_i - turned) / sigma.
/// Metres and radians; [Bucci 2025] eq. (6), first sum.
class XyzYawFactor {
 public:
  static constexpr int kDim = 4;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  /// `motion`: x, y, z [m], yaw [rad]; `variance` of each.
  XyzYawFactor(const Eigen::Vector4d& motion, const Eigen::Vector4d& variance)
      : motion_(motion), inv_sigma_(variance.cwiseSqrt().cwiseInverse()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x_i, const NavVector& x_j,
                                  Jacobian* J_i = nullptr, Jacobian* J_j = nullptr) const {
    const double c = std::cos(x_i(kNavYaw)), s = std::sin(x_i(kNavYaw));
    const Eigen::Vector3d d = x_j.head<3>() - x_i.head<3>();
    const double ahead = c * d.x() + s * d.y(), abeam = -s * d.x() + c * d.y();
    if (J_i != nullptr) {
      J_i->setZero();
      J_i->row(0) << -c, -s, 0.0, abeam, 0.0, 0.0;
      J_i->row(1) << s, -c, 0.0, -ahead, 0.0, 0.0;
      (*J_i)(2, kNavZ) = -1.0;
      (*J_i)(3, kNavYaw) = -1.0;
      *J_i = (inv_sigma_.asDiagonal() * *J_i).eval();
    }
    if (J_j != nullptr) {
      J_j->setZero();
      J_j->row(0) << c, s, 0.0, 0.0, 0.0, 0.0;
      J_j->row(1) << -s, c, 0.0, 0.0, 0.0, 0.0;
      (*J_j)(2, kNavZ) = 1.0;
      (*J_j)(3, kNavYaw) = 1.0;
      *J_j = (inv_sigma_.asDiagonal() * *J_j).eval();
    }
    Residual r(ahead - motion_(0), abeam - motion_(1), d.z() - motion_(2),
               WrapAngle(x_j(kNavYaw) - x_i(kNavYaw) - motion_(3)));
    return r.cwiseProduct(inv_sigma_);
  }

 private:
  Eigen::Vector4d motion_, inv_sigma_;
};

}  // namespace limpet
