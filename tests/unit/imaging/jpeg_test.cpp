// SPDX-License-Identifier: MIT
#include "limpet/imaging/jpeg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

Image Checkered() {
  Image image{64, 48, std::vector<std::uint8_t>(3U * 64U * 48U)};
  for (std::size_t i = 0; i < image.bgr.size(); ++i) {
    image.bgr[i] = static_cast<std::uint8_t>((i / 3 / 5 + i / 3 / 64 / 5) % 2 == 0 ? 60 : 180);
  }
  return image;
}

double DifferenceAt(int quality) {
  Image image = Checkered();
  Jpeg(quality).Compress(image);
  double sum = 0.0;
  const Image before = Checkered();
  for (std::size_t i = 0; i < image.bgr.size(); ++i)
    sum += std::abs(image.bgr[i] - before.bgr[i]);
  return sum / static_cast<double>(image.bgr.size());
}

TEST(Jpeg, LosesMoreAtLowerQuality) {
  EXPECT_GT(DifferenceAt(20), DifferenceAt(85));
  EXPECT_GT(DifferenceAt(85), 0.0);
  EXPECT_LT(DifferenceAt(85), 8.0);
}

TEST(Jpeg, LeavesWhatACodecLeaves) {
  // Soft waves of colour with noise, of a size that is no multiple of a block.
  Image image{203, 149, std::vector<std::uint8_t>(3U * 203U * 149U)};
  Random random(8);
  for (int row = 0; row < image.height_px; ++row) {
    for (int column = 0; column < image.width_px; ++column) {
      for (int c = 0; c < 3; ++c) {
        const double wave = std::sin(0.07 * row + 0.4 * c) * std::cos(0.05 * column);
        const double level = 120.0 + 60.0 * wave + random.Normal(6.0);
        image.bgr[static_cast<std::size_t>(3 * (row * image.width_px + column) + c)] =
            static_cast<std::uint8_t>(std::clamp(level, 0.0, 255.0));
      }
    }
  }
  for (const int quality : {30, 60, 85, 95}) {
    std::vector<std::uint8_t> bytes;
    const cv::Mat pixels(image.height_px, image.width_px, CV_8UC3, image.bgr.data());
    cv::imencode(".jpg", pixels, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
    const cv::Mat theirs = cv::imdecode(bytes, cv::IMREAD_COLOR);
    Image own = image;
    Jpeg(quality).Compress(own);
    const cv::Mat ours(image.height_px, image.width_px, CV_8UC3, own.bgr.data());
    // Rounding and how colour is scaled up differ; what is lost is several levels.
    EXPECT_LT(cv::norm(ours, theirs, cv::NORM_L1) / static_cast<double>(image.bgr.size()), 1.5);
    EXPECT_GT(cv::norm(ours, pixels, cv::NORM_L1), 1.5 * cv::norm(ours, theirs, cv::NORM_L1));
  }
}

TEST(Jpeg, OfQualityZeroLeavesThePictureAsItIs) { EXPECT_EQ(DifferenceAt(0), 0.0); }

}  // namespace
}  // namespace limpet
