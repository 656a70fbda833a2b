// SPDX-License-Identifier: MIT
#include "limpet/vision/ground_contrast.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/vision/contrast_model.hpp"
#include "limpet/vision/scene_renderer.hpp"
#include "limpet/vision/water_optics.hpp"

namespace limpet {
namespace {

Image GroundPicture(double visibility, double altitude, std::uint64_t place = 5,
                    std::span<const Sphere> spheres = {}) {
  SceneRenderer renderer({.camera = {},
                          .seabed_depth = [](const Eigen::Vector2d&) { return 12.0; },
                          .visibility_m = visibility,
                          .seabed_seed = place,
                          .noise_seed = 6});
  Pose pose;
  pose.p_WB = {2.0, 1.0, 12.0 - altitude};
  return renderer.Render(pose, spheres, 1);
}

double GreenOf(const Image& image) { return MeasureGroundContrast(image.view()).green; }

TEST(GroundContrast, FadesWithDistanceAsTheWaterHasIt) {
  for (const double visibility : {8.0, 12.0}) {
    const double near = GreenOf(GroundPicture(visibility, 2.0)),
                 far = GreenOf(GroundPicture(visibility, 4.0));
    const double per_m = WaterOptics::OfVisibility(visibility).attenuation_per_m[1];
    EXPECT_NEAR(std::log(near / far) / 2.0, per_m, 0.35 * per_m) << visibility;
  }
}

TEST(GroundContrast, DoesNotStandOutOfTheNoiseInMurk) {
  const GroundContrast murk = MeasureGroundContrast(GroundPicture(2.0, 4.0).view());
  EXPECT_LT(murk.green, 1.5 * murk.noise);
  const GroundContrast clear = MeasureGroundContrast(GroundPicture(8.0, 4.0).view());
  EXPECT_GT(clear.green, 2.5 * clear.noise);
}

TEST(GroundContrast, AnObjectInThePictureIsNotTheGround) {
  const Sphere ball{{2.3, 1.4, 11.5}, 0.5, "yellow"};
  EXPECT_NEAR(GreenOf(GroundPicture(8.0, 4.0, 5, std::span(&ball, 1))),
              GreenOf(GroundPicture(8.0, 4.0)), 0.25 * GreenOf(GroundPicture(8.0, 4.0)));
}

TEST(GroundContrast, ExposureDoesNotMatter) {
  Image image = GroundPicture(8.0, 3.0);
  const double before = GreenOf(image);
  for (std::uint8_t& value : image.bgr) {
    value = static_cast<std::uint8_t>(std::lround(0.75 * value));
  }
  EXPECT_NEAR(GreenOf(image), before, 0.2 * before);
}

TEST(GroundContrast, TakesAPictureOfAnyShape) {
  const Image tiny{8, 8, std::vector<std::uint8_t>(192, 100)};
  EXPECT_EQ(GreenOf(tiny), 0.0);
  const Image flat{640, 64, std::vector<std::uint8_t>(std::size_t{3} * 640 * 64, 0)};
  EXPECT_EQ(GreenOf(flat), 0.0);
}

/// Without pictures the simulator must not be kinder, nor harsher, than with them.
TEST(ContrastModel, IsLikeThePictures) {
  for (const double visibility : {3.0, 8.0, 12.0}) {
    for (const double altitude : {2.0, 4.0}) {
      double drawn = 0.0, pictured = 0.0;
      constexpr int kSites = 60, kPlaces = 4;
      for (int i = 0; i < kSites; ++i) {
        Random site(static_cast<std::uint64_t>(i) + 1), images(100);
        drawn += std::log(ContrastModel(visibility, site).Draw(altitude, images).green) / kSites;
      }
      for (int i = 0; i < kPlaces; ++i) {
        const auto place = static_cast<std::uint64_t>(20 + i);
        pictured += std::log(GreenOf(GroundPicture(visibility, altitude, place))) / kPlaces;
      }
      EXPECT_NEAR(drawn, pictured, 0.5) << visibility << " m, from " << altitude << " m";
    }
  }
}

}  // namespace
}  // namespace limpet
