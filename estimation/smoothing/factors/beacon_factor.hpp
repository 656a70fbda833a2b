// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <Eigen/Geometry>

#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Slant range from a transducer on the vehicle to a beacon at a known place, or at one that is off
/// it by three slow errors:
///   r = (|p_WB + R_WB p_BS - p_WT - off| - measured) / sigma.
/// Says nothing of the direction: where both coincide the derivative is zero. That of the lever arm
/// takes yaw only; roll and pitch move a transducer by centimetres.
class BeaconFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  /// `p_WT`: of the beacon; `p_BS`: of the transducer [m].
  BeaconFactor(const Eigen::Vector3d& p_WT, const Eigen::Vector3d& p_BS, Meters measured,
               Meters sigma)
      : p_WT_(p_WT), p_BS_(p_BS), measured_(measured.value()), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    return Evaluate(x, Eigen::Vector3d::Zero(), J);
  }
  /// `off_W`: from where the beacon is said to be to where it is [m].
  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& off_W,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_off = nullptr) const {
    const Pose X_WB = PoseOf(x);
    const Eigen::Vector3d arm_W = RotationOf(X_WB) * p_BS_;
    const Eigen::Vector3d away = X_WB.p_WB + arm_W - p_WT_ - off_W;
    const double distance = away.norm();
    const Eigen::RowVector3d along = inv_sigma_ / std::max(distance, kNearest) * away.transpose();
    if (J_pose != nullptr) {
      J_pose->setZero();
      J_pose->head<3>() = along;
      (*J_pose)(kNavYaw) = along * Eigen::Vector3d::UnitZ().cross(arm_W);
    }
    if (J_off != nullptr) *J_off = -along;
    return Residual((distance - measured_) * inv_sigma_);
  }

 private:
  static constexpr double kNearest = 1e-6;  ///< [m]
  Eigen::Vector3d p_WT_, p_BS_;
  double measured_, inv_sigma_;
};

}  // namespace limpet
