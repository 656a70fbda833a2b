// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "estimation/smoothing/factors/cut_axis_factor.hpp"
#include "estimation/smoothing/factors/range_factor.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"
#include "estimation/smoothing/nav_vector.hpp"
#include "limpet/core/camera_model.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {

/// A tilted camera off the body's origin, over an object ahead and below.
class LandmarkFactorTest : public ::testing::Test {
 protected:
  static CameraModel Tilted() {
    CameraModel camera;
    const double c = std::cos(0.4), s = std::sin(0.4);
    camera.R_BC << 0.0, -c, s, 1.0, 0.0, 0.0, 0.0, s, c;
    camera.p_BC = {0.25, 0.1, 0.15};
    return camera;
  }
  template <class F>
  void ExpectJacobiansMatch(const F& factor) {
    typename F::Jacobian J_pose;
    typename F::BorderJacobian J_landmark;
    const auto r = factor.Evaluate(x_, p_W_, &J_pose, &J_landmark);
    EXPECT_GT(r.norm(), 0.0);
    const auto of_x = [&](const NavVector& x) { return Eigen::VectorXd(factor.Evaluate(x, p_W_)); };
    const auto of_p = [&](const Eigen::Vector3d& p) {
      return Eigen::VectorXd(factor.Evaluate(x_, p));
    };
    EXPECT_LT((J_pose - NumericJacobian(of_x, x_)).template lpNorm<Eigen::Infinity>(), 1e-4);
    EXPECT_LT((J_landmark - NumericJacobian(of_p, p_W_)).template lpNorm<Eigen::Infinity>(), 1e-4);
  }
  Eigen::Vector3d InCamera() const {
    const Pose X_WB = PoseOf(x_);
    const Eigen::Vector3d p_B = RotationOf(X_WB).transpose() * (p_W_ - X_WB.p_WB);
    return camera_.R_BC.transpose() * (p_B - camera_.p_BC);
  }

  const CameraModel camera_ = Tilted();
  const NavVector x_ = (NavVector() << 3.0, -2.0, 3.5, 2.5, 0.1, -0.2).finished();
  const Eigen::Vector3d p_W_{1.0, -1.5, 7.0};
};

}  // namespace limpet
