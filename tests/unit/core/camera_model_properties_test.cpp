// SPDX-License-Identifier: MIT
// One camera for all: what it projects it finds again, however it is mounted.
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

class CameraModelProperties : public ::testing::TestWithParam<int> {
 protected:
  static CameraModel Draw(Random& random) {
    CameraModel camera = CameraModel::FromFieldOfView(
        320 + static_cast<int>(random.Index(1600)), 240 + static_cast<int>(random.Index(1000)),
        {.across = RadiansFromDegrees(random.Uniform(30.0, 110.0)),
         .along = RadiansFromDegrees(random.Uniform(30.0, 90.0))});
    camera.cx += random.Uniform(-20.0, 20.0);
    camera.cy += random.Uniform(-20.0, 20.0);
    camera.R_BC = RotationFromRollPitchYaw(random.Normal(0.2), random.Normal(0.2),
                                           random.Uniform(-3.1, 3.1)) *
                  camera.R_BC;
    camera.p_BC = {random.Normal(0.3), random.Normal(0.3), random.Normal(0.3)};
    return camera;
  }
  [[nodiscard]] Pose DrawPoseAnywhere() {
    return {{random_.Normal(30.0), random_.Normal(30.0), random_.Normal(10.0)},
            random_.Uniform(-0.6, 0.6),
            random_.Uniform(-0.6, 0.6),
            random_.Uniform(-3.1, 3.1)};
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "camera"};
  const CameraModel camera_ = Draw(random_);
};

TEST_P(CameraModelProperties, TheRayOfAPixelLeadsThroughIt) {
  for (int i = 0; i < 100; ++i) {
    const double u = random_.Uniform(0.0, camera_.width_px);
    const double v = random_.Uniform(0.0, camera_.height_px);
    const Eigen::Vector3d ray_C = camera_.RayOf({u, v});
    EXPECT_NEAR(ray_C.norm(), 1.0, 1e-12);
    const auto pixel = camera_.Project(random_.Uniform(0.1, 50.0) * ray_C);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), u, 1e-8);
    EXPECT_NEAR(pixel->y(), v, 1e-8);
  }
}

TEST_P(CameraModelProperties, NothingBehindTheCameraHasAPixel) {
  for (int i = 0; i < 50; ++i) {
    EXPECT_FALSE(
        camera_.Project({random_.Normal(3.0), random_.Normal(3.0), -random_.Uniform(0.0, 10.0)}));
  }
}

TEST_P(CameraModelProperties, WorldAndCameraAreOneRigidMotionApart) {
  for (int i = 0; i < 50; ++i) {
    const Pose X_WB = DrawPoseAnywhere();
    const Eigen::Vector3d a(random_.Normal(5.0), random_.Normal(5.0), random_.Normal(5.0));
    const Eigen::Vector3d b(random_.Normal(5.0), random_.Normal(5.0), random_.Normal(5.0));
    EXPECT_NEAR((camera_.InCamera(X_WB, a) - camera_.InCamera(X_WB, b)).norm(), (a - b).norm(),
                1e-9);
    // The camera's own place, by its lever arm.
    const Eigen::Vector3d here_W = X_WB.p_WB + RotationOf(X_WB) * camera_.p_BC;
    EXPECT_LT(camera_.InCamera(X_WB, here_W).norm(), 1e-9);
  }
}

TEST_P(CameraModelProperties, TheFieldOfViewIsTheAngleBetweenTheImagesEdges) {
  CameraModel centred = camera_;
  centred.cx = 0.5 * centred.width_px, centred.cy = 0.5 * centred.height_px;
  const Eigen::Vector3d left = centred.RayOf({0.0, centred.cy});
  const Eigen::Vector3d right = centred.RayOf({centred.width_px, centred.cy});
  const Eigen::Vector3d top = centred.RayOf({centred.cx, 0.0});
  const Eigen::Vector3d bottom = centred.RayOf({centred.cx, centred.height_px});
  EXPECT_NEAR(std::acos(left.dot(right)), centred.fov_across(), 1e-9);
  EXPECT_NEAR(std::acos(top.dot(bottom)), centred.fov_along(), 1e-9);
  const CameraModel again =
      CameraModel::FromFieldOfView(centred.width_px, centred.height_px,
                                   {.across = centred.fov_across(), .along = centred.fov_along()});
  EXPECT_NEAR(again.fx, centred.fx, 1e-9);
  EXPECT_NEAR(again.fy, centred.fy, 1e-9);
}

TEST_P(CameraModelProperties, AsMadeStarboardIsToTheRightAndAftDown) {
  const CameraModel made;
  const double depth = random_.Uniform(1.0, 8.0), off = random_.Uniform(0.1, 1.0);
  const auto middle = made.Project(made.InCamera(Pose{}, {0.0, 0.0, depth}));
  const auto starboard = made.Project(made.InCamera(Pose{}, {0.0, off, depth}));
  const auto aft = made.Project(made.InCamera(Pose{}, {-off, 0.0, depth}));
  EXPECT_GT(starboard->x(), middle->x());
  EXPECT_NEAR(starboard->y(), middle->y(), 1e-9);
  EXPECT_GT(aft->y(), middle->y());
  EXPECT_NEAR(aft->x(), middle->x(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, CameraModelProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet
