// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/factors/camera_factor.hpp"

namespace limpet {

/// The centre of a landmark's box:  r = (projected - measured) / sigma, per axis [px];
/// [Bucci 2025] eq. (6), fourth sum. An axis along which the border cuts the box has an infinite
/// sigma and counts nothing. Behind or near the camera the residual is large and its derivative
/// zero, so that a wild estimate does no harm.
class ReprojectionFactor : public CameraFactor<ReprojectionFactor, 2> {
 public:
  /// `camera` must outlive the factor.
  ReprojectionFactor(const CameraModel& camera, const Eigen::Vector2d& measured_px,
                     const Eigen::Vector2d& sigma_px)
      : CameraFactor(camera), measured_(measured_px), inv_sigma_(sigma_px.cwiseInverse()) {}

  /// Residual of a point in the camera's frame, with the derivative by it.
  [[nodiscard]] Residual InCamera(const Eigen::Vector3d& p_C, BorderJacobian& J_C) const {
    J_C.setZero();
    Residual r = Residual::Constant(kLost_px).cwiseProduct(inv_sigma_);
    if (p_C.z() > kNearest) {
      const double k = 1.0 / p_C.z();
      r = Residual(camera().cx + camera().fx * p_C.x() * k,
                   camera().cy + camera().fy * p_C.y() * k);
      r = (r - measured_).cwiseProduct(inv_sigma_);
      J_C << camera().fx * k, 0.0, -camera().fx * p_C.x() * k * k,  //
          0.0, camera().fy * k, -camera().fy * p_C.y() * k * k;
      J_C = (inv_sigma_.asDiagonal() * J_C).eval();
    }
    return r;
  }

 private:
  static constexpr double kNearest = 0.2;  ///< [m]
  Eigen::Vector2d measured_, inv_sigma_;
};

}  // namespace limpet
