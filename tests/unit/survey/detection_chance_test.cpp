// SPDX-License-Identifier: MIT
#include "limpet/survey/detection_chance.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const CameraModel kTestedCamera;
const Pose kAbove{{0.0, 0.0, 0.0}, 0.0, 0.0, 0.0};

TEST(VisibleShare, IsOneInTheMiddleOfTheImage) {
  EXPECT_EQ(VisibleShare(kTestedCamera, kAbove, {0, 0, 3}, 0.5), 1.0);
}

TEST(VisibleShare, IsAHalfOnTheImagesEdge) {
  const double edge = 3.0 * kTestedCamera.half_along();
  EXPECT_NEAR(VisibleShare(kTestedCamera, kAbove, {edge, 0, 3}, 0.5), 0.5, 0.1);
}

TEST(VisibleShare, IsNoneOutsideOrBehind) {
  EXPECT_EQ(VisibleShare(kTestedCamera, kAbove, {0, 9, 3}, 0.5), 0.0);
  EXPECT_EQ(VisibleShare(kTestedCamera, kAbove, {0, 0, -3}, 0.5), 0.0);
}

TEST(DetectionChance, IsBestCloseByAndWhole) {
  const DetectionModel model;
  EXPECT_NEAR(DetectionChance(model, {.range = 1.0, .share = 1.0}), model.best, 1e-3);
}

TEST(DetectionChance, FallsWithRangeAndWithTheShareInTheImage) {
  const DetectionModel model;
  for (double range = 1.0; range < 12.0; range += 1.0) {
    EXPECT_GE(DetectionChance(model, {.range = range, .share = 1.0}),
              DetectionChance(model, {.range = range + 1.0, .share = 1.0}));
  }
  for (double share = 0.0; share < 1.0; share += 0.1) {
    EXPECT_LE(DetectionChance(model, {.range = 2.0, .share = share}),
              DetectionChance(model, {.range = 2.0, .share = share + 0.1}));
  }
  EXPECT_LT(DetectionChance(model, {.range = 2.0 * model.visibility.value(), .share = 1.0}), 0.01);
  EXPECT_EQ(DetectionChance(model, {.range = 2.0, .share = 0.1}), 0.0);
}

TEST(DetectionChance, AtHalfItsRangeHalfOfTheChanceIsLeft) {
  const DetectionModel model{.visibility = Meters(5.0)};
  EXPECT_NEAR(DetectionChance(model, {.range = HalfRange(model), .share = 1.0}),
              0.5 * DetectionChance(model, {.range = 0.5, .share = 1.0}), 0.01);
}

TEST(DetectionChance, OfAnotherDetectorReachesAsFarAsItsFileSays) {
  const DetectionModel model{.visibility = Meters(5.0), .half_range = 0.6, .fall_off = 0.1};
  EXPECT_DOUBLE_EQ(HalfRange(model), 3.0);
  EXPECT_NEAR(DetectionChance(model, {.range = 3.0, .share = 1.0}), 0.5 * model.best, 0.01);
  EXPECT_NEAR(MeanVisibility(model, VisibilityBelief(Meters(5.0), 1.2)).value(), 5.0, 0.4);
}

TEST(DetectionChance, FindsHalfOfWhatIsAsSmallAsItsLeast) {
  const DetectionModel model{.least_size_px = 20.0};
  EXPECT_DOUBLE_EQ(SizeFactor(model, 20.0), 0.5);
  EXPECT_LT(SizeFactor(model, 10.0), 0.01);
  EXPECT_GT(SizeFactor(model, 40.0), 0.99);
}

TEST(DetectionChance, MeanVisibilityFollowsWhatIsBelievedOfTheWater) {
  const DetectionModel model;
  EXPECT_NEAR(MeanVisibility(model, VisibilityBelief(Meters(8.0), 2.0)).value(), 8.0, 0.4);
  EXPECT_NEAR(MeanVisibility(model, VisibilityBelief(Meters(2.0), 1.2)).value(), 2.0, 0.15);
}

}  // namespace
}  // namespace limpet
