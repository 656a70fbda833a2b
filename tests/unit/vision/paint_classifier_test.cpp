// SPDX-License-Identifier: MIT
#include "limpet/vision/paint_classifier.hpp"

#include <string>

#include <gtest/gtest.h>

#include "limpet/objects/color_table.hpp"

namespace limpet {
namespace {

/// Blue, green, red: what of the light sand throws back; the paints' are of the colour table.
const Eigen::Array3d kSand(0.16, 0.25, 0.30);
const Eigen::Array3d kWhiteLight = Eigen::Array3d::Ones();

Eigen::Array3d PaintOf(const std::string& name) {
  const Albedo albedo = AlbedoOf(name).value();
  return {albedo[0], albedo[1], albedo[2]};
}

/// As a camera develops it [levels].
Eigen::Vector3d LevelsOf(const Eigen::Array3d& light) { return 255.0 * light.pow(1.0 / 2.2); }

std::string ColorOf(const Eigen::Array3d& paint, double shade, const Eigen::Array3d& light) {
  const auto warm = ClassifyWarmInShade(LevelsOf(shade * paint * light), LevelsOf(kSand * light));
  return warm ? warm->color : "none";
}

class WarmPaint : public testing::TestWithParam<const char*> {};

TEST_P(WarmPaint, StaysItselfInAnyShade) {
  for (const double shade : {0.3, 0.5, 0.8, 1.2})
    EXPECT_EQ(ColorOf(PaintOf(GetParam()), shade, kWhiteLight), GetParam()) << shade;
}

TEST_P(WarmPaint, StaysItselfInTheLightOfDeepWaterAndOfDusk) {
  const Eigen::Array3d deep(0.9, 0.8, 0.4), dusk(0.5, 0.6, 0.9);  // in water red is lost first
  for (const double shade : {0.5, 1.0}) {
    EXPECT_EQ(ColorOf(PaintOf(GetParam()), shade, deep), GetParam()) << shade;
    EXPECT_EQ(ColorOf(PaintOf(GetParam()), shade, dusk), GetParam()) << shade;
  }
}
INSTANTIATE_TEST_SUITE_P(PaintClassifier, WarmPaint, testing::Values("yellow", "orange", "red"));

TEST(PaintClassifier, ABareOrBlueThingIsNoWarmPaint) {
  EXPECT_EQ(ColorOf(kSand, 1.0, kWhiteLight), "none");
  EXPECT_EQ(ColorOf(kSand, 0.4, kWhiteLight), "none") << "a dark stone";
  EXPECT_EQ(ColorOf(PaintOf("blue"), 1.0, kWhiteLight), "none");
}

TEST(PaintClassifier, APaintBetweenTwoIsNeitherForCertain) {
  double least = 1.0;
  for (double share = 0.0; share <= 1.0; share += 0.02) {
    const Eigen::Array3d mixed = share * PaintOf("yellow") + (1.0 - share) * PaintOf("orange");
    const auto paint = ClassifyWarmInShade(LevelsOf(mixed), LevelsOf(kSand));
    ASSERT_TRUE(paint);
    least = std::min(least, paint->certainty);
    if (share < 0.01 || share > 0.99) {
      EXPECT_EQ(paint->certainty, 1.0) << share;
    }
  }
  EXPECT_LT(least, 0.3);
}

}  // namespace
}  // namespace limpet
