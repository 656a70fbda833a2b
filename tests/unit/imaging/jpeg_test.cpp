// SPDX-License-Identifier: MIT
#include "limpet/imaging/jpeg.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

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

TEST(Jpeg, OfQualityZeroLeavesThePictureAsItIs) { EXPECT_EQ(DifferenceAt(0), 0.0); }

}  // namespace
}  // namespace limpet
