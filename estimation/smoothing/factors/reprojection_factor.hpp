// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/camera_point.hpp"

namespace limpet {

/// The centre of a landmark's box:  r = (projected - measured) / sigma, per axis [px];
/// [Bucci 2025] eq. (6), fourth sum. An axis along which the border cuts the box has an infinite
/// sigma and counts nothing. Behind or near the camera the residual is large and its derivative
/// zero, so that a wild estimate does no harm.
class ReprojectionFactor {
 public:
  static constexpr int kDim = 2;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  /// `camera` must outlive the factor.
  ReprojectionFactor(const CameraModel& camera, const Eigen::Vector2d& measured_px,
                     const Eigen::Vector2d& sigma_px)
      : camera_(&camera), measured_(measured_px), inv_sigma_(sigma_px.cwiseInverse()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p_W,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_landmark = nullptr) const {
    const CameraPoint point = CameraPointOf(*camera_, x, p_W);
    BorderJacobian J_C;
    Residual r = InCamera(point.p_C, J_C);
    if (J_pose != nullptr) *J_pose = J_C * point.J_pose;
    if (J_landmark != nullptr) *J_landmark = J_C * point.J_landmark;
    return r;
  }
  /// Of a point in the camera's frame, with the derivative by it.
  [[nodiscard]] Residual InCamera(const Eigen::Vector3d& p_C, BorderJacobian& J_C) const {
    J_C.setZero();
    Residual r = Residual::Constant(kLost_px).cwiseProduct(inv_sigma_);
    if (p_C.z() > kNearest) {
      const double k = 1.0 / p_C.z();
      r = Residual(camera_->cx + camera_->fx * p_C.x() * k,
                   camera_->cy + camera_->fy * p_C.y() * k);
      r = (r - measured_).cwiseProduct(inv_sigma_);
      J_C << camera_->fx * k, 0.0, -camera_->fx * p_C.x() * k * k,  //
          0.0, camera_->fy * k, -camera_->fy * p_C.y() * k * k;
      J_C = (inv_sigma_.asDiagonal() * J_C).eval();
    }
    return r;
  }

 private:
  static constexpr double kNearest = 0.2;  ///< [m]
  const CameraModel* camera_;
  Eigen::Vector2d measured_, inv_sigma_;
};

}  // namespace limpet
