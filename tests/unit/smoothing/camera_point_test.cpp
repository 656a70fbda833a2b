// SPDX-License-Identifier: MIT
// Where a landmark is in the camera, and how that follows pose and landmark.
#include "estimation/smoothing/camera_point.hpp"

#include <cstdint>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

class CameraPointProperties : public ::testing::TestWithParam<int> {
 protected:
  static CameraModel DrawMounted(Random& random) {
    CameraModel camera;
    camera.R_BC = RotationFromRollPitchYaw(random.Normal(0.3), random.Normal(0.3),
                                           random.Uniform(-3.1, 3.1)) *
                  camera.R_BC;
    camera.p_BC = {random.Normal(0.5), random.Normal(0.5), random.Normal(0.5)};
    return camera;
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "camera point"};
  const CameraModel camera_ = DrawMounted(random_);
  const NavVector x_ =
      (NavVector() << random_.Normal(20.0), random_.Normal(20.0), random_.Uniform(0.0, 20.0),
       random_.Uniform(-3.1, 3.1), random_.Uniform(-0.5, 0.5), random_.Uniform(-0.5, 0.5))
          .finished();
  const Eigen::Vector3d p_W_ =
      x_.head<3>() + Eigen::Vector3d(random_.Normal(3.0), random_.Normal(3.0), 4.0);
};

TEST_P(CameraPointProperties, IsWhatTheCameraModelSays) {
  Pose X_WB;
  X_WB.p_WB = x_.head<3>();
  X_WB.yaw = x_(kNavYaw), X_WB.pitch = x_(kNavPitch), X_WB.roll = x_(kNavRoll);
  EXPECT_LT((CameraPointOf(camera_, x_, p_W_).p_C - camera_.InCamera(X_WB, p_W_)).norm(), 1e-9);
}

TEST_P(CameraPointProperties, ItsJacobiansMatchCentralDifferences) {
  const CameraPoint point = CameraPointOf(camera_, x_, p_W_);
  const auto of_pose = [&](const NavVector& x) {
    return Eigen::VectorXd(CameraPointOf(camera_, x, p_W_).p_C);
  };
  const auto of_landmark = [&](const Eigen::Vector3d& p) {
    return Eigen::VectorXd(CameraPointOf(camera_, x_, p).p_C);
  };
  EXPECT_LT((point.J_pose - NumericJacobian(of_pose, x_)).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_LT((point.J_landmark - NumericJacobian(of_landmark, p_W_)).lpNorm<Eigen::Infinity>(),
            1e-6);
}

TEST_P(CameraPointProperties, MovingWorldAndBodyTogetherChangesNothing) {
  const Eigen::Vector3d shift_W(random_.Normal(50.0), random_.Normal(50.0), random_.Normal(5.0));
  NavVector moved = x_;
  moved.head<3>() += shift_W;
  EXPECT_LT(
      (CameraPointOf(camera_, moved, p_W_ + shift_W).p_C - CameraPointOf(camera_, x_, p_W_).p_C)
          .norm(),
      1e-9);
}

TEST_P(CameraPointProperties, TheLandmarksJacobianIsARotation) {
  const Eigen::Matrix3d J = CameraPointOf(camera_, x_, p_W_).J_landmark;
  EXPECT_TRUE((J * J.transpose()).isIdentity(1e-9));
  EXPECT_NEAR(J.determinant(), 1.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, CameraPointProperties, ::testing::Range(1, 13));

}  // namespace
}  // namespace limpet
