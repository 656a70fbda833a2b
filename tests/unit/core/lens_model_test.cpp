// SPDX-License-Identifier: MIT
#include "limpet/core/lens_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr LensDistortion kBarrel{.k1 = -0.18, .k2 = 0.03, .p1 = 0.002, .p2 = -0.003, .k3 = -0.002};
constexpr LensDistortion kPincushion{.k1 = 0.12, .k2 = -0.02, .p1 = -0.001, .p2 = 0.002};

class Lens : public ::testing::TestWithParam<LensDistortion> {
 protected:
  LensModel lens_ = LensModel(CameraModel(), GetParam());
  const CameraModel& image_ = lens_.image();
};

TEST_P(Lens, EveryPixelOfTheImageComesBack) {
  for (int u = 0; u <= image_.width_px; u += 20) {
    for (int v = 0; v <= image_.height_px; v += 20) {
      const Eigen::Vector2d pixel(u, v);
      const Eigen::Vector2d there = lens_.ToPinhole(lens_.rectified(), pixel);
      EXPECT_LT((lens_.FromPinhole(lens_.rectified(), there) - pixel).norm(), 1e-5);
    }
  }
}

TEST_P(Lens, WhatTheRectifiedCameraShowsIsInTheImage) {
  const CameraModel& camera = lens_.rectified();
  EXPECT_GT(camera.width_px, 0.75 * image_.width_px);
  for (int u = 0; u <= camera.width_px; u += 10) {
    for (int v = 0; v <= camera.height_px; v += 10) {
      const Eigen::Vector2d pixel = lens_.FromPinhole(camera, Eigen::Vector2d(u, v));
      EXPECT_TRUE(pixel.x() > -0.05 && pixel.x() < image_.width_px + 0.05) << u << ' ' << v;
      EXPECT_TRUE(pixel.y() > -0.05 && pixel.y() < image_.height_px + 0.05) << u << ' ' << v;
    }
  }
}

TEST_P(Lens, TheEnclosingCameraShowsTheWholeImage) {
  const CameraModel& camera = lens_.enclosing();
  for (int u = 0; u <= image_.width_px; u += 10) {
    for (int v = 0; v <= image_.height_px; v += 10) {
      const Eigen::Vector2d pixel = lens_.ToPinhole(camera, Eigen::Vector2d(u, v));
      EXPECT_TRUE(pixel.x() > -0.05 && pixel.x() < camera.width_px + 0.05) << u << ' ' << v;
      EXPECT_TRUE(pixel.y() > -0.05 && pixel.y() < camera.height_px + 0.05) << u << ' ' << v;
    }
  }
}

TEST_P(Lens, ARayIsTheSameThroughEitherPinhole) {
  const Eigen::Vector2d pixel(500.0, 100.0);
  const auto ray = [&](const CameraModel& camera) {
    const Eigen::Vector2d there = lens_.ToPinhole(camera, pixel);
    return camera.RayOf(there);
  };
  EXPECT_LT((ray(lens_.rectified()) - ray(lens_.enclosing())).norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(BothWays, Lens, ::testing::Values(kBarrel, kPincushion));

TEST(LensModel, WithoutDistortionIsItsPinholeBitForBit) {
  const CameraModel image;
  const LensModel lens(image, {});
  EXPECT_TRUE(lens.is_pinhole());
  EXPECT_EQ(lens.rectified().fx, image.fx);
  EXPECT_EQ(lens.rectified().cx, image.cx);
  EXPECT_EQ(lens.enclosing().width_px, image.width_px);
}

TEST(LensModel, AStraightLineBendsTowardsTheAxisThroughABarrel) {
  // By hand: x = 0.5, r2 = 0.25, factor 1 - 0.1 * 0.25.
  EXPECT_NEAR((LensDistortion{.k1 = -0.1}.Applied({0.5, 0.0}).x()), 0.4875, 1e-12);
  EXPECT_NEAR((LensDistortion{.p2 = 0.01}.Applied({0.5, 0.0}).x()), 0.5 + 0.01 * 0.75, 1e-12);
  EXPECT_NEAR((LensDistortion{.p1 = 0.01}.Applied({0.5, 0.0}).y()), 0.01 * 0.25, 1e-12);
}

TEST(LensModel, OneThatFoldsItsImageIsFound) {
  EXPECT_FALSE(LensModel::IsOneToOne(CameraModel(), {.k1 = -0.6}));
  EXPECT_FALSE(LensModel::IsOneToOne(CameraModel(), {.k1 = std::nan("")}));
  EXPECT_TRUE(LensModel::IsOneToOne(CameraModel(), kBarrel));
}

}  // namespace
}  // namespace limpet
