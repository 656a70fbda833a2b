// SPDX-License-Identifier: MIT
// What published planar sets measure, as factors on the chain's poses and blocks of its border.
#pragma once

#include <algorithm>
#include <cmath>

#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"

namespace limpet {

/// A vehicle in the plane: r = (z, pitch, roll) / sigma.
class PlaneFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  explicit PlaneFactor(double sigma) : inv_sigma_(1.0 / sigma) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    if (J != nullptr) {
      J->setZero();
      (*J)(0, kNavZ) = (*J)(1, kNavPitch) = (*J)(2, kNavRoll) = inv_sigma_;
    }
    return inv_sigma_ * Residual(x(kNavZ), x(kNavPitch), x(kNavRoll));
  }

 private:
  double inv_sigma_;
};

/// A step that was measured backwards, from the later pose to the earlier one.
template <class Step>
class BackwardFactor {
 public:
  static constexpr int kDim = Step::kDim;
  using Residual = typename Step::Residual;
  using Jacobian = typename Step::Jacobian;

  explicit BackwardFactor(const Step& step) : step_(step) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x_i, const NavVector& x_j,
                                  Jacobian* J_i = nullptr, Jacobian* J_j = nullptr) const {
    return step_.Evaluate(x_j, x_i, J_j, J_i);
  }

 private:
  Step step_;
};

/// Ties a block of the border to a pose, so that it stands for the place of that pose:
///   r = ((x, y, yaw) - block) / sigma.
class PlaceFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  explicit PlaceFactor(double sigma) : inv_sigma_(1.0 / sigma) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& place,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_place = nullptr) const {
    if (J_pose != nullptr) {
      J_pose->setZero();
      (*J_pose)(0, kNavX) = (*J_pose)(1, kNavY) = (*J_pose)(2, kNavYaw) = inv_sigma_;
    }
    if (J_place != nullptr) *J_place = -inv_sigma_ * BorderJacobian::Identity();
    const Eigen::Vector3d off(x(kNavX) - place.x(), x(kNavY) - place.y(),
                              WrapAngle(x(kNavYaw) - place.z()));
    return inv_sigma_ * off;
  }

 private:
  double inv_sigma_;
};

/// A planar motion between a pose and a place (x, y, yaw): XyzYawFactor with the place's pose in
/// the plane, from the pose to the place or, if `is_from_place`, the other way.
class PlaceEdgeFactor {
 public:
  static constexpr int kDim = XyzYawFactor::kDim;
  using Residual = XyzYawFactor::Residual;
  using Jacobian = XyzYawFactor::Jacobian;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  PlaceEdgeFactor(const XyzYawFactor& edge, bool is_from_place)
      : edge_(edge), is_from_place_(is_from_place) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& place,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_place = nullptr) const {
    NavVector x_place = NavVector::Zero();
    x_place(kNavX) = place.x(), x_place(kNavY) = place.y(), x_place(kNavYaw) = place.z();
    Jacobian J_x, J_x_place;
    const Residual r = is_from_place_ ? edge_.Evaluate(x_place, x, &J_x_place, &J_x)
                                      : edge_.Evaluate(x, x_place, &J_x, &J_x_place);
    if (J_pose != nullptr) *J_pose = J_x;
    if (J_place != nullptr)
      *J_place << J_x_place.col(kNavX), J_x_place.col(kNavY), J_x_place.col(kNavYaw);
    return r;
  }

 private:
  XyzYawFactor edge_;
  bool is_from_place_;
};

/// Bearing, from ahead towards the pose's y axis, and range of a landmark in the plane; its third
/// coordinate is held at zero:  r = ((bearing, range) - measured, z) / sigma.
class BearingRangeFactor {
 public:
  static constexpr int kDim = 3;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  BearingRangeFactor(const Eigen::Vector2d& measured, const Eigen::Vector2d& sigma)
      : measured_(measured), inv_sigma_(sigma.cwiseInverse()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_landmark = nullptr) const {
    const Eigen::Vector2d d = p.head<2>() - x.head<2>();
    const double range = std::max(d.norm(), 1e-6);
    BorderJacobian J = BorderJacobian::Identity();
    J.topLeftCorner<2, 2>() << -d.y() / (range * range), d.x() / (range * range), d.x() / range,
        d.y() / range;
    J.topRows<2>() = (inv_sigma_.asDiagonal() * J.topRows<2>()).eval();
    if (J_pose != nullptr) {
      J_pose->setZero();
      J_pose->topLeftCorner<2, 2>() = -J.topLeftCorner<2, 2>();
      (*J_pose)(0, kNavYaw) = -inv_sigma_(0);
    }
    if (J_landmark != nullptr) *J_landmark = J;
    const double bearing = std::atan2(d.y(), d.x()) - x(kNavYaw);
    return {WrapAngle(bearing - measured_(0)) * inv_sigma_(0),
            (range - measured_(1)) * inv_sigma_(1), p.z()};
  }

 private:
  Eigen::Vector2d measured_, inv_sigma_;
};

/// Distance in the plane from a beacon whose ranges are off by a scale of its own; the block is
/// (x, y, scale error):  r = ((1 + scale error) |p - p_B| - measured) / sigma.
class ScaledDistanceFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  ScaledDistanceFactor(double measured, double sigma)
      : measured_(measured), inv_sigma_(1.0 / sigma) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& beacon,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_beacon = nullptr) const {
    const Eigen::Vector2d d = beacon.head<2>() - x.head<2>();
    const double distance = std::max(d.norm(), 1e-6), scale = 1.0 + beacon.z();
    const Eigen::RowVector2d J = inv_sigma_ * scale / distance * d.transpose();
    if (J_pose != nullptr) *J_pose << -J, 0.0, 0.0, 0.0, 0.0;
    if (J_beacon != nullptr) *J_beacon << J, inv_sigma_ * distance;
    return Residual((scale * distance - measured_) * inv_sigma_);
  }

 private:
  double measured_, inv_sigma_;
};

}  // namespace limpet
