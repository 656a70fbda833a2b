// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "estimation/smoothing/camera_point.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// The one edge that shows of a box that the border cuts along an axis:
///   r = (projected tangent of a sphere of known radius - measured) / sigma [px].
/// Exact while the other axis is not cut. Near the camera plane, or inside the sphere, the residual
/// is large and its derivative zero.
class EdgeFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  /// Which edge: along u (0) or v (1), and its lower (-1) or upper (1) end.
  struct Edge {
    int axis = 0;
    int side = 1;
    double measured_px = 0.0;
    double sigma_px = 1.0;
  };
  /// `camera` must outlive the factor.
  EdgeFactor(const CameraModel& camera, Meters radius, const Edge& edge)
      : camera_(&camera), radius_(radius.value()), edge_(edge) {}

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
    Residual J_size;
    return InCamera(p_C, 0.0, J_C, J_size);
  }
  /// For a sphere exp(log_size) times as large, also with the derivative by that.
  [[nodiscard]] Residual InCamera(const Eigen::Vector3d& p_C, double log_size, BorderJacobian& J_C,
                                  Residual& J_size) const {
    const double radius = radius_ * std::exp(log_size);
    const double along = p_C(edge_.axis), depth = p_C.z();
    const double f = edge_.axis == 0 ? camera_->fx : camera_->fy;
    const double c = edge_.axis == 0 ? camera_->cx : camera_->cy;
    const double distance = std::hypot(along, depth);
    J_C.setZero();
    J_size.setZero();
    Residual r(kLost_px / edge_.sigma_px);
    const double half = std::asin(std::min(radius / std::max(distance, 1e-6), 1.0));
    const double angle = std::atan2(along, depth) + edge_.side * half;
    if (distance > 1.02 * radius && std::abs(angle) < kWidest) {
      const double squared = distance * distance;
      const double tangent = std::sqrt(squared - radius * radius);
      const double d_half = -radius / (squared * tangent);
      const double stretch = f / (std::cos(angle) * std::cos(angle)) / edge_.sigma_px;
      J_C(edge_.axis) = stretch * (depth / squared + edge_.side * d_half * along);
      J_C(2) = stretch * (-along / squared + edge_.side * d_half * depth);
      J_size(0) = stretch * edge_.side * radius / tangent;
      r(0) = (c + f * std::tan(angle) - edge_.measured_px) / edge_.sigma_px;
    }
    return r;
  }

 private:
  static constexpr double kWidest = 1.4;  ///< [rad]
  const CameraModel* camera_;
  double radius_;
  Edge edge_;
};

}  // namespace limpet
