// SPDX-License-Identifier: MIT
#include "limpet/imaging/sensor.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

LinearImage Even(float blue, float green, float red) {
  LinearImage image(kWidth, kHeight, kWidth);
  std::ranges::fill(image.planes[0], blue);
  std::ranges::fill(image.planes[1], green);
  std::ranges::fill(image.planes[2], red);
  return image;
}

ImageParams::Sensor Noiseless() {
  ImageParams::Sensor params;
  params.full_well = 1e6;
  params.read_noise = 0.0;
  params.contrast = 0.0;
  params.saturation = 1.0;
  return params;
}

Image Developed(const ImageParams::Sensor& params, const LinearImage& light,
                std::uint32_t frame = 0) {
  Sensor sensor(params, kWidth, 11);
  Image image{kWidth, kHeight, std::vector<std::uint8_t>(3U * kWidth * kHeight)};
  sensor.Develop(light, sensor.Meter(light), frame, image);
  return image;
}

struct Level {
  double mean = 0.0, sigma = 0.0;
};
Level LevelOf(const Image& image, std::size_t channel) {
  double sum = 0.0;
  double sum2 = 0.0;
  for (std::size_t i = channel; i < image.bgr.size(); i += 3) {
    sum += image.bgr[i];
    sum2 += static_cast<double>(image.bgr[i]) * image.bgr[i];
  }
  const double count = kWidth * kHeight;
  return {sum / count, std::sqrt(std::max(sum2 / count - sum * sum / (count * count), 0.0))};
}

TEST(Sensor, ExposesBrightAndDimScenesAlike) {
  const double bright = LevelOf(Developed(Noiseless(), Even(0.4F, 0.4F, 0.4F)), 1).mean;
  const double dim = LevelOf(Developed(Noiseless(), Even(0.01F, 0.01F, 0.01F)), 1).mean;
  EXPECT_NEAR(bright, dim, 1.5);
  EXPECT_NEAR(bright, 121.0, 4.0);  // middle grey in sRGB's gamma
}

TEST(Sensor, AStopMoreDoublesTheLight) {
  ImageParams::Sensor params = Noiseless();
  params.exposure = 1.0;
  const double level = LevelOf(Developed(params, Even(0.1F, 0.1F, 0.1F)), 1).mean;
  EXPECT_NEAR(level, 255.0 * (1.055 * std::pow(0.38, 1.0 / 2.4) - 0.055), 2.0);
}

TEST(Sensor, WhiteBalanceTakesItsShareOfTheCast) {
  const LinearImage green = Even(0.10F, 0.20F, 0.05F);
  ImageParams::Sensor params = Noiseless();
  params.white_balance = 1.0;
  const Image gray = Developed(params, green);
  EXPECT_NEAR(LevelOf(gray, 0).mean, LevelOf(gray, 1).mean, 1.0);
  EXPECT_NEAR(LevelOf(gray, 2).mean, LevelOf(gray, 1).mean, 1.0);
  params.white_balance = 0.0;
  const Image cast = Developed(params, green);
  EXPECT_GT(LevelOf(cast, 1).mean, LevelOf(cast, 0).mean + 30.0);
  EXPECT_GT(LevelOf(cast, 0).mean, LevelOf(cast, 2).mean + 20.0);
}

TEST(Sensor, NoiseIsThatOfTheElectrons) {
  ImageParams::Sensor params = Noiseless();
  params.full_well = 2000.0;
  params.exposure = 0.0;
  const LinearImage light = Even(0.1F, 0.1F, 0.1F);  // exposure 1.9 times: no amplification
  const double measured = LevelOf(Developed(params, light), 1).sigma;
  const double signal = 0.19;
  const double electrons_sigma = std::sqrt(signal / 2000.0);
  const double slope = 255.0 * 1.055 / 2.4 * std::pow(signal, 1.0 / 2.4 - 1.0);
  EXPECT_NEAR(measured, slope * electrons_sigma, 0.08 * measured);
}

TEST(Sensor, DimScenesAreNoisier) {
  ImageParams::Sensor params;
  EXPECT_GT(LevelOf(Developed(params, Even(0.001F, 0.001F, 0.001F)), 1).sigma,
            2.0 * LevelOf(Developed(params, Even(0.1F, 0.1F, 0.1F)), 1).sigma);
}

TEST(Sensor, NoiseIsEqualForEqualFramesAlone) {
  const LinearImage light = Even(0.1F, 0.1F, 0.1F);
  const ImageParams::Sensor params;
  EXPECT_EQ(Developed(params, light, 5).bgr, Developed(params, light, 5).bgr);
  EXPECT_NE(Developed(params, light, 5).bgr, Developed(params, light, 6).bgr);
}

TEST(Sensor, DarknessIsNoTrouble) {
  EXPECT_EQ(Developed({}, Even(0.0F, 0.0F, 0.0F)).bgr.size(), 3U * kWidth * kHeight);
}

}  // namespace
}  // namespace limpet
