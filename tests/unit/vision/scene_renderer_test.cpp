// SPDX-License-Identifier: MIT
#include "limpet/vision/scene_renderer.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

SceneSettings SceneWith(double visibility_m = 8.0) {
  return {.camera = {},
          .seabed_depth =
              [](const Eigen::Vector2d& p_W) {
                return 7.5 + 0.05 * std::sin(1.3 * p_W.x()) * std::cos(0.8 * p_W.y());
              },
          .visibility_m = visibility_m,
          .seabed_seed = 5,
          .noise_seed = 6};
}

Pose Above(double altitude) {
  Pose pose;
  pose.p_WB = {0.0, 0.0, 7.5 - altitude};
  return pose;
}

/// Mean blue, green, red of a square of pixels.
Eigen::Vector3d MeanColor(const Image& image, int left, int top, int side) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int row = top; row < top + side; ++row) {
    for (int column = left; column < left + side; ++column) {
      const std::uint8_t* pixel = image.view().pixel(column, row);
      sum += Eigen::Vector3d(pixel[0], pixel[1], pixel[2]);
    }
  }
  return sum / (side * side);
}

const std::vector<Sphere> kBalls{{{0.3, 0.4, 7.0}, 0.5, "yellow"}, {{-0.8, -1.0, 6.0}, 0.3, "red"}};

TEST(SceneRenderer, EqualInputGivesEqualBytes) {
  SceneRenderer one(SceneWith());
  SceneRenderer two(SceneWith());
  const Image first = one.Render(Above(4.0), kBalls, 7);
  static_cast<void>(two.Render(Above(2.0), {}, 3));  // what it drew before must not matter
  EXPECT_EQ(first.bgr, two.Render(Above(4.0), kBalls, 7).bgr);
}

TEST(SceneRenderer, NoiseDiffersFromFrameToFrame) {
  SceneRenderer renderer(SceneWith());
  EXPECT_NE(renderer.Render(Above(4.0), {}, 1).bgr, renderer.Render(Above(4.0), {}, 2).bgr);
}

TEST(SceneRenderer, SizeIsTheCameras) {
  SceneSettings settings = SceneWith();
  settings.camera.width_px = 101;
  settings.camera.height_px = 67;
  const Image image = SceneRenderer(settings).Render(Above(3.0), kBalls, 0);
  EXPECT_EQ(image.bgr.size(), 3U * 101U * 67U);
}

TEST(SceneRenderer, YellowBallShowsMoreRedAndLessBlueThanTheSand) {
  SceneRenderer renderer(SceneWith());
  const Sphere ball{{0.0, 0.0, 7.0}, 0.5, "yellow"};
  const Image image = renderer.Render(Above(3.0), std::span(&ball, 1), 0);
  const Eigen::Vector3d inside = MeanColor(image, 310, 230, 20);
  const Eigen::Vector3d sand = MeanColor(image, 60, 230, 20);
  EXPECT_GT(inside(2), sand(2) + 15.0);
  EXPECT_LT(inside(0), sand(0) - 3.0);
}

TEST(SceneRenderer, HazeSwallowsContrastWithDistance) {
  const Sphere ball{{0.0, 0.0, 7.0}, 0.5, "yellow"};
  const auto contrast = [&ball](double visibility) {
    SceneRenderer renderer(SceneWith(visibility));
    const Image with = renderer.Render(Above(4.0), std::span(&ball, 1), 0);
    const Image without = renderer.Render(Above(4.0), {}, 0);
    return (MeanColor(with, 310, 230, 20) - MeanColor(without, 310, 230, 20)).norm();
  };
  EXPECT_GT(contrast(15.0), 1.5 * contrast(6.0));
  EXPECT_GT(contrast(6.0), 1.5 * contrast(3.0));
  EXPECT_LT(contrast(1.5), 2.0);
}

TEST(SceneRenderer, NearerBallHidesTheFartherInAnyOrder) {
  SceneRenderer renderer(SceneWith());
  const Sphere high{{0.0, 0.0, 5.5}, 0.4, "red"};
  const Sphere low{{0.0, 0.0, 7.0}, 0.5, "green"};
  const std::vector<Sphere> one{high, low};
  const std::vector<Sphere> other{low, high};
  EXPECT_EQ(renderer.Render(Above(4.0), one, 0).bgr, renderer.Render(Above(4.0), other, 0).bgr);
}

TEST(SceneRenderer, SeabedMovesWithTheCamera) {
  // A quarter metre to the north moves the image down by the focal length over the distance.
  SceneRenderer renderer(SceneWith(30.0));
  const Image before = renderer.Render(Above(3.0), {}, 0);
  Pose moved = Above(3.0);
  moved.p_WB.x() += 0.25;
  const Image after = renderer.Render(moved, {}, 0);
  const CameraModel camera;
  const int shift = static_cast<int>(std::lround(0.25 * camera.fy / 3.0));
  const auto difference = [&](int rows) {
    double sum = 0.0;
    for (int row = 150; row < 300; ++row) {
      for (int column = 200; column < 440; ++column) {
        sum += std::abs(before.view().pixel(column, row)[1] -
                        after.view().pixel(column, row + rows)[1]);
      }
    }
    return sum;
  };
  EXPECT_LT(difference(shift), 0.7 * difference(0));
  EXPECT_LT(difference(shift), 0.7 * difference(-shift));
}

TEST(SceneRenderer, SurvivesAHorizonInTheImage) {
  SceneRenderer renderer(SceneWith());
  Pose pose = Above(3.0);
  pose.roll = 1.2;
  EXPECT_EQ(renderer.Render(pose, kBalls, 0).bgr.size(), 3U * 640U * 480U);
}

}  // namespace
}  // namespace limpet
