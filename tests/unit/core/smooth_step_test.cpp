// SPDX-License-Identifier: MIT
#include "limpet/core/smooth_step.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SmoothStep, RisesFromNoneToAllByThreeSquaresLessTwoCubes) {
  EXPECT_EQ(SmoothStep(0.0), 0.0);
  EXPECT_EQ(SmoothStep(1.0), 1.0);
  EXPECT_EQ(SmoothStep(0.5), 0.5);
  EXPECT_EQ(SmoothStep(0.25), 0.15625);
  EXPECT_EQ(SmoothStep(0.25F), 0.15625F);
}

TEST(SmoothStep, IsLevelAtBothEnds) {
  constexpr double kNear = 1e-4;
  EXPECT_LT(SmoothStep(kNear), 4.0 * kNear * kNear);
  EXPECT_LT(1.0 - SmoothStep(1.0 - kNear), 4.0 * kNear * kNear);
}

TEST(SmoothStep, NeverFallsAndIsTheSameSeenFromTheOtherEnd) {
  for (int i = 0; i < 100; ++i) {
    const double t = i / 100.0;
    EXPECT_LT(SmoothStep(t), SmoothStep(t + 0.01));
    EXPECT_NEAR(SmoothStep(t) + SmoothStep(1.0 - t), 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace limpet
