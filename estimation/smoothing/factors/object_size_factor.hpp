// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>

#include "estimation/smoothing/factors/camera_errors_factor.hpp"
#include "estimation/smoothing/jacobians.hpp"

namespace limpet {

/// A factor of a camera (CutAxisFactor, RangeFactor) that takes the sphere's radius for known.
template <class F>
concept TakesSize = requires(const F& factor, const Eigen::Vector3d& p_C,
                             typename F::BorderJacobian& J_C, typename F::Residual& J_size) {
  factor.InCamera(p_C, 0.0, J_C, J_size);
};

/// F for a sphere of a given size.
template <TakesSize F>
class AtSize {
 public:
  static constexpr int kDim = F::kDim;
  using Residual = typename F::Residual;
  using Jacobian = typename F::Jacobian;
  using BorderJacobian = typename F::BorderJacobian;

  /// `J_size` takes the derivative by `log_size`; all must outlive the factor.
  AtSize(const F& factor, double log_size, Residual& J_size)
      : factor_(&factor), log_size_(log_size), J_size_(&J_size) {}
  [[nodiscard]] Residual InCamera(const Eigen::Vector3d& p_C, BorderJacobian& J_C) const {
    return factor_->InCamera(p_C, log_size_, J_C, *J_size_);
  }

 private:
  const F* factor_;
  double log_size_;
  Residual* J_size_;
};

/// A look at an object whose size is estimated with pose, landmark and the camera's errors: the
/// logarithm of its share of what is believed of it, one of three in a border variable.
template <TakesSize F>
class ObjectSizeFactor {
 public:
  static constexpr int kDim = F::kDim;
  using Residual = typename F::Residual;
  using Jacobian = typename F::Jacobian;
  using BorderJacobian = typename F::BorderJacobian;
  /// Derivatives by the pose, and by landmark, tilt, shift and sizes.
  using Jacobians = ObservationJacobians<kDim, 4>;

  /// `camera`: as its file says; must outlive the factor. `index` of the size in the variable;
  /// `believed`: logarithm of what is believed of it as a share of the radius that F has.
  ObjectSizeFactor(const CameraModel& camera, const BodyMotion& motion, F factor, int index,
                   double believed)
      : camera_(&camera),
        motion_(motion),
        factor_(std::move(factor)),
        index_(index),
        believed_(believed) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p_W,
                                  const Eigen::Vector3d& tilt_B,
                                  const Eigen::Vector3d& lever_and_delay,
                                  const Eigen::Vector3d& log_sizes, Jacobians* J = nullptr) const {
    Residual J_size;
    const double log_size = believed_ + log_sizes(index_);
    const CameraErrorsFactor look(*camera_, motion_, AtSize(factor_, log_size, J_size));
    if (J == nullptr) {
      return look.Evaluate(x, p_W, tilt_B, lever_and_delay);
    }
    typename decltype(look)::Jacobians J_look;
    Residual r = look.Evaluate(x, p_W, tilt_B, lever_and_delay, &J_look);
    J->pose = J_look.pose;
    std::ranges::copy(J_look.border, J->border.begin());
    J->border.back().setZero();
    J->border.back().col(index_) = J_size;
    return r;
  }

 private:
  const CameraModel* camera_;
  BodyMotion motion_;
  F factor_;
  int index_;
  double believed_;
};

}  // namespace limpet
