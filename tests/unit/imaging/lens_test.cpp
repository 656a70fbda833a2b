// SPDX-License-Identifier: MIT
#include "limpet/imaging/lens.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace limpet {
namespace {

LinearImage PointOfLight() {
  LinearImage image(64, 48, 64);
  for (std::size_t c = 0; c < 3; ++c)
    image.row(c, 24)[32] = 1.0F;
  return image;
}

double Sum(const LinearImage& image) {
  return std::accumulate(image.planes[1].begin(), image.planes[1].end(), 0.0);
}

TEST(Lens, BlursAPointToItsWidthAndKeepsItsLight) {
  LinearImage image = PointOfLight();
  Lens(ImageParams::Lens{.blur = 1.5, .vignette = 0.0}).Blur(image, 0.0);
  EXPECT_NEAR(Sum(image), 1.0, 1e-4);
  double spread2 = 0.0;
  for (int column = 0; column < 64; ++column) {
    double share = 0.0;
    for (int row = 0; row < 48; ++row)
      share += image.row(1, row)[column];
    spread2 += share * (column - 32) * (column - 32);
  }
  EXPECT_NEAR(std::sqrt(spread2), 1.5, 0.1);
}

TEST(Lens, WithoutBlurAndGlowChangesNothing) {
  LinearImage image = PointOfLight();
  Lens(ImageParams::Lens{.blur = 0.0, .vignette = 0.0}).Blur(image, 0.0);
  EXPECT_EQ(image.planes, PointOfLight().planes);
}

TEST(Lens, GlowTakesItsShareOfAPointAndSpreadsItAround) {
  LinearImage image = PointOfLight();
  Lens(ImageParams::Lens{.blur = 0.0, .vignette = 0.0}).Blur(image, 0.3);
  EXPECT_NEAR(image.row(1, 24)[32], 0.7, 0.01);
  EXPECT_GT(image.row(1, 24)[44], 0.0F);
  EXPECT_NEAR(Sum(image), 1.0, 0.03);
}

TEST(Lens, VignetteIsNoneInTheMiddleAndAllInTheCorner) {
  const ImageParams::Lens lens{.blur = 0.0, .vignette = 0.4};
  EXPECT_EQ(VignetteAt(lens, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(VignetteAt(lens, 1.0), 0.6);
}

}  // namespace
}  // namespace limpet
