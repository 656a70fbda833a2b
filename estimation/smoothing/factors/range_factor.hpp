// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "estimation/smoothing/factors/camera_factor.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Distance of a sphere of known radius from the size of its box:
///   r = (mean of the centre's distances in the camera's xz and yz planes - measured) / sigma.
/// In each of these planes a half-angle a of the box means exactly radius / sin(a). Use with a
/// robust loss, and never in a plane in which the border cuts the box.
class RangeFactor : public CameraFactor<RangeFactor, 1> {
 public:
  /// Weights of the distances in the xz and yz planes: of a whole box the mean.
  using PlaneWeights = Eigen::Vector2d;
  [[nodiscard]] static PlaneWeights BothPlanes() { return {0.5, 0.5}; }

  /// `camera` must outlive the factor.
  RangeFactor(const CameraModel& camera, Meters measured, Meters sigma,
              const PlaneWeights& planes = BothPlanes())
      : CameraFactor(camera),
        measured_(measured.value()),
        inv_sigma_(1.0 / sigma.value()),
        planes_(planes) {}

  /// Residual of a point in the camera's frame, with the derivative by it.
  [[nodiscard]] Residual InCamera(const Eigen::Vector3d& p_C, BorderJacobian& J_C) const {
    Residual J_size;
    return InCamera(p_C, 0.0, J_C, J_size);
  }
  /// Residual for a sphere exp(log_size) times as large, also with the derivative by that.
  [[nodiscard]] Residual InCamera(const Eigen::Vector3d& p_C, double log_size, BorderJacobian& J_C,
                                  Residual& J_size) const {
    const double xz = std::max(std::hypot(p_C.x(), p_C.z()), 1e-6);
    const double yz = std::max(std::hypot(p_C.y(), p_C.z()), 1e-6);
    const double scale = inv_sigma_ * std::exp(-log_size);
    const double by_xz = scale * planes_.x() / xz, by_yz = scale * planes_.y() / yz;
    J_C = Eigen::RowVector3d(by_xz * p_C.x(), by_yz * p_C.y(), (by_xz + by_yz) * p_C.z());
    const double range = planes_.dot(Eigen::Vector2d(xz, yz));
    J_size = Residual(-scale * range);
    return Residual(scale * range - measured_ * inv_sigma_);
  }

 private:
  double measured_, inv_sigma_;
  PlaneWeights planes_;
};

}  // namespace limpet
