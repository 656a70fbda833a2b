// SPDX-License-Identifier: MIT
#include "limpet/vision/sphere_box.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

TEST(ImageOfSphere, OnTheAxisIsACircleAroundTheMiddle) {
  const CameraModel camera;
  const auto image = ImageOfSphere(camera, {0.0, 0.0, 5.0}, 0.5);
  ASSERT_TRUE(image);
  // The silhouette's half angle is asin(r / d), not atan(r / d).
  const double half = camera.fx * std::tan(std::asin(0.1));
  EXPECT_NEAR(image->outline.center_u(), 320.0, 1e-9);
  EXPECT_NEAR(image->outline.width(), 2.0 * half, 1e-9);
  EXPECT_NEAR(image->visible_fraction, 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(image->range, 5.0);
}

TEST(ImageOfSphere, BoxHoldsEveryPointOfTheSphereAndTouchesItsEdges) {
  const CameraModel camera;
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Vector3d p_C(random.Uniform(-1.5, 1.5), random.Uniform(-1.0, 1.0),
                              random.Uniform(2.5, 6.0));
    const auto image = ImageOfSphere(camera, p_C, 0.4);
    ASSERT_TRUE(image);
    PixelRect points{1e9, 1e9, -1e9, -1e9};
    for (int i = 0; i < 40000; ++i) {
      const Eigen::Vector3d direction(random.Normal(1.0), random.Normal(1.0), random.Normal(1.0));
      const auto pixel = camera.Project(p_C + 0.4 * direction.normalized());
      ASSERT_TRUE(pixel);
      points = {std::min(points.left, pixel->x()), std::min(points.top, pixel->y()),
                std::max(points.right, pixel->x()), std::max(points.bottom, pixel->y())};
    }
    EXPECT_GE(points.left, image->outline.left - 1e-9);
    EXPECT_LE(points.bottom, image->outline.bottom + 1e-9);
    EXPECT_NEAR(points.left, image->outline.left, 0.5);
    EXPECT_NEAR(points.top, image->outline.top, 0.5);
    EXPECT_NEAR(points.right, image->outline.right, 0.5);
    EXPECT_NEAR(points.bottom, image->outline.bottom, 0.5);
  }
}

TEST(ImageOfSphere, OffTheAxisTheBoxIsNotAroundTheProjectedCentre) {
  const CameraModel camera;
  const Eigen::Vector3d p_C(1.5, 0.0, 2.5);
  const auto image = ImageOfSphere(camera, p_C, 0.4);
  ASSERT_TRUE(image);
  EXPECT_GT(image->outline.center_u(), camera.Project(p_C)->x() + 2.0);
}

TEST(ImageOfSphere, HalfOutsideIsHalfVisible) {
  const CameraModel camera;
  const double edge = camera.half_along();
  const auto image = ImageOfSphere(camera, {0.0, 20.0 * edge, 20.0}, 0.3);
  ASSERT_TRUE(image);
  EXPECT_NEAR(image->visible_fraction, 0.5, 0.02);
  EXPECT_NEAR(image->visible.bottom, camera.height_px, 1e-9);
}

TEST(ImageOfSphere, CutAtACornerItsVisibleBoxIsSmallerThanTheClippedOutline) {
  // A long lens, so that the silhouette is nearly a circle; its centre is outside both borders.
  const CameraModel camera = CameraModel::FromFieldOfView(
      640, 480, {.across = RadiansFromDegrees(20.0), .along = RadiansFromDegrees(15.0)});
  const Eigen::Vector3d p_C(-20.0 * camera.half_across() - 0.25, -20.0 * camera.half_along() - 0.25,
                            20.0);
  const auto image = ImageOfSphere(camera, p_C, 0.5);
  ASSERT_TRUE(image);
  EXPECT_LT(image->visible.right, image->outline.right - 2.0);
  EXPECT_LT(image->visible.bottom, image->outline.bottom - 2.0);
}

TEST(ImageOfSphere, NothingBehindOrBesideTheCamera) {
  const CameraModel camera;
  EXPECT_FALSE(ImageOfSphere(camera, {0.0, 0.0, -3.0}, 0.5));
  EXPECT_FALSE(ImageOfSphere(camera, {9.0, 0.0, 3.0}, 0.5));
  EXPECT_FALSE(ImageOfSphere(camera, {0.0, 0.0, 0.3}, 0.5));
}

TEST(PixelRect, OverlapOfEqualAndOfApartRectangles) {
  const PixelRect a{0.0, 0.0, 10.0, 10.0};
  EXPECT_DOUBLE_EQ(Overlap(a, a), 1.0);
  EXPECT_DOUBLE_EQ(Overlap(a, {20.0, 0.0, 30.0, 10.0}), 0.0);
  EXPECT_DOUBLE_EQ(Overlap(a, {5.0, 0.0, 15.0, 10.0}), 1.0 / 3.0);
}

}  // namespace
}  // namespace limpet
