// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

#include "estimation/smoothing/camera_errors.hpp"
#include "estimation/smoothing/camera_point.hpp"
#include "estimation/smoothing/jacobians.hpp"

namespace limpet {

/// A factor of a camera (ReprojectionFactor, CutAxisFactor, RangeFactor) whose extrinsics and clock
/// are estimated with pose and landmark: what F says of the point where it then is in the camera.
template <class F>
class CameraErrorsFactor {
 public:
  static constexpr int kDim = F::kDim;
  using Residual = typename F::Residual;
  using Jacobian = typename F::Jacobian;
  using BorderJacobian = typename F::BorderJacobian;
  /// Derivatives by the pose, and by landmark, tilt and shift.
  using Jacobians = ObservationJacobians<kDim, 3>;

  /// `camera`: as its file says; must outlive the factor.
  CameraErrorsFactor(const CameraModel& camera, const BodyMotion& motion, F factor)
      : camera_(&camera), motion_(motion), factor_(std::move(factor)) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p_W,
                                  const Eigen::Vector3d& tilt_B,
                                  const Eigen::Vector3d& lever_and_delay,
                                  Jacobians* J = nullptr) const {
    const CameraErrors errors{.tilt_B = tilt_B, .lever_and_delay = lever_and_delay};
    const CameraPoint point = CameraPointOf(WithErrors(*camera_, errors, motion_), x, p_W);
    const CameraErrorJacobians by_errors = ErrorJacobiansOf(*camera_, errors, motion_, point.p_C);
    BorderJacobian J_C;
    Residual r = factor_.InCamera(point.p_C, J_C);
    if (J != nullptr) {
      J->pose = J_C * point.J_pose;
      J->border[0] = J_C * point.J_landmark;
      J->border[1] = J_C * by_errors.J_tilt;
      J->border[2] = J_C * by_errors.J_shift;
    }
    return r;
  }

 private:
  const CameraModel* camera_;
  BodyMotion motion_;
  F factor_;
};

}  // namespace limpet
