// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/camera_point.hpp"

namespace limpet {

/// What the factors of a camera share: the way from pose and landmark to the camera's frame. F has
///   Residual InCamera(const Eigen::Vector3d& p_C, BorderJacobian& J_C) const,
/// of a point in that frame, with the derivative by it.
template <class F, int kRows>
class CameraFactor {
 public:
  static constexpr int kDim = kRows;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;
  using BorderJacobian = Eigen::Matrix<double, kDim, 3>;

  [[nodiscard]] Residual Evaluate(const NavVector& x, const Eigen::Vector3d& p_W,
                                  Jacobian* J_pose = nullptr,
                                  BorderJacobian* J_landmark = nullptr) const {
    const CameraPoint point = CameraPointOf(*camera_, x, p_W);
    BorderJacobian J_C;
    Residual r = static_cast<const F&>(*this).InCamera(point.p_C, J_C);
    if (J_pose != nullptr) *J_pose = J_C * point.J_pose;
    if (J_landmark != nullptr) *J_landmark = J_C * point.J_landmark;
    return r;
  }

 protected:
  /// `camera` must outlive the factor.
  explicit CameraFactor(const CameraModel& camera) : camera_(&camera) {}
  [[nodiscard]] const CameraModel& camera() const { return *camera_; }

 private:
  const CameraModel* camera_;
};

}  // namespace limpet
