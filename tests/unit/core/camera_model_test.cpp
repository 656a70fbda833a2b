// SPDX-License-Identifier: MIT
#include "limpet/core/camera_model.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(CameraModel, GivesBackTheFieldOfViewItWasMadeFrom) {
  const CameraModel camera = CameraModel::FromFieldOfView(640, 360, {.across = 1.2, .along = 0.8});
  EXPECT_NEAR(camera.fov_across(), 1.2, 1e-12);
  EXPECT_NEAR(camera.fov_along(), 0.8, 1e-12);
  EXPECT_EQ(camera.cx, 320.0);
  EXPECT_EQ(camera.cy, 180.0);
}

TEST(CameraModel, SeesTheEdgeOfItsFieldOfViewAtTheBorder) {
  const CameraModel camera;
  const auto pixel = camera.Project({3.0 * camera.half_across(), -3.0 * camera.half_along(), 3.0});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 640.0, 1e-9);
  EXPECT_NEAR(pixel->y(), 0.0, 1e-9);
}

TEST(CameraModel, LooksStraightDownUnlessToldOtherwise) {
  const CameraModel camera;
  const Pose over{{10.0, 20.0, 3.0}, 0.0, 0.0, 0.0};
  EXPECT_TRUE(camera.InCamera(over, {10.0, 20.0, 7.0}).isApprox(Eigen::Vector3d(0, 0, 4), 1e-12));
  // Ahead is up in the image, starboard to the right.
  EXPECT_LT(camera.InCamera(over, {11.0, 20.0, 7.0}).y(), 0.0);
  EXPECT_GT(camera.InCamera(over, {10.0, 21.0, 7.0}).x(), 0.0);
}

TEST(CameraModel, RayAndProjectionUndoEachOtherForAnyMounting) {
  CameraModel camera;
  camera.fx = 500.0, camera.fy = 480.0, camera.cx = 310.0, camera.cy = 250.0;
  camera.p_BC = {0.3, 0.1, 0.2};
  camera.R_BC = CameraModel::LookingDown() * RotationFromRollPitchYaw(0.1, -0.2, 0.05);
  const Pose X_WB{{1.0, 2.0, 3.0}, 0.1, 0.2, 0.7};
  const Eigen::Vector3d p_C = camera.InCamera(X_WB, {2.0, 2.5, 8.0});
  const auto pixel = camera.Project(p_C);
  ASSERT_TRUE(pixel);
  EXPECT_TRUE(camera.RayOf(*pixel).isApprox(p_C.normalized(), 1e-12));
}

TEST(CameraModel, ShowsNothingBehindItself) {
  EXPECT_FALSE(CameraModel().Project({0.1, 0.1, -2.0}).has_value());
}

}  // namespace
}  // namespace limpet
