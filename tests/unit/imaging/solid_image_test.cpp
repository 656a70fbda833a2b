// SPDX-License-Identifier: MIT
#include "limpet/imaging/solid_image.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/vision/sphere_box.hpp"

namespace limpet {
namespace {

Solid At(SolidKind kind, const Eigen::Vector3d& p_W) {
  return {.kind = kind, .p_W = p_W, .radius = 0.4, .height = kind == SolidKind::kTyre ? 0.2 : 0.9};
}

TEST(SolidImage, OutlineOfASphereIsTheExactOne) {
  const CameraModel camera;
  Pose pose;
  pose.roll = 0.2;
  const Solid ball = At(SolidKind::kSphere, {0.7, -1.1, 3.0});
  const auto outline = OutlineOf(camera, pose, ball);
  const auto exact = ImageOfSphere(camera, camera.InCamera(pose, ball.p_W), ball.radius);
  ASSERT_TRUE(outline && exact);
  EXPECT_NEAR(outline->left, exact->outline.left, 1e-3);
  EXPECT_NEAR(outline->top, exact->outline.top, 1e-3);
  EXPECT_NEAR(outline->right, exact->outline.right, 1e-3);
  EXPECT_NEAR(outline->bottom, exact->outline.bottom, 1e-3);
}

TEST(SolidImage, OutlineOfABoxIsThatOfItsCorners) {
  const CameraModel camera;
  const Pose pose;
  Solid box = At(SolidKind::kBox, {0.5, 0.9, 3.0});
  box.R_WS = RotationFromRollPitchYaw(0.3, 0.8, 1.1);
  double left = 1e9;
  double bottom = -1e9;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p_S((corner & 1) != 0 ? 0.4 : -0.4, (corner & 2) != 0 ? 0.4 : -0.4,
                              (corner & 4) != 0 ? 0.45 : -0.45);
    const auto pixel = camera.Project(camera.InCamera(pose, box.p_W + box.R_WS * p_S));
    left = std::min(left, pixel->x());
    bottom = std::max(bottom, pixel->y());
  }
  EXPECT_NEAR(OutlineOf(camera, pose, box)->left, left, 1e-3);
  EXPECT_NEAR(OutlineOf(camera, pose, box)->bottom, bottom, 1e-3);
}

TEST(SolidImage, UprightCylinderBelowTheCameraShowsItsTop) {
  const CameraModel camera;
  const auto outline = OutlineOf(camera, {}, At(SolidKind::kCylinder, {0.0, 0.0, 3.0}));
  EXPECT_NEAR(outline->width(), 2.0 * camera.fx * 0.4 / (3.0 - 0.45), 1e-3);
}

TEST(SolidImage, ThatReachesBehindTheCameraIsNone) {
  EXPECT_FALSE(OutlineOf({}, {}, At(SolidKind::kCone, {0.0, 0.0, 0.3})));
  EXPECT_FALSE(OutlineOf({}, {}, At(SolidKind::kTyre, {0.0, 0.0, -3.0})));
}

}  // namespace
}  // namespace limpet
