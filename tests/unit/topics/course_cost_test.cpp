// SPDX-License-Identifier: MIT
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/topics/energy.hpp"

namespace limpet {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(CourseCost, IsInterpolatedBetweenItsStepsAllAround) {
  const CourseCost cost{.metres = {2.0, 1.0, 0.5, 1.0}};
  EXPECT_DOUBLE_EQ(cost.At(0.0), 2.0);
  EXPECT_DOUBLE_EQ(cost.At(0.25 * kPi), 1.5);
  EXPECT_DOUBLE_EQ(cost.At(kPi), 0.5);
  EXPECT_DOUBLE_EQ(cost.At(-0.25 * kPi), 1.5);
  EXPECT_DOUBLE_EQ(cost.At(6.25 * kPi), 1.5);
}

TEST(CourseCost, IsOneOfEveryCourseWhereNoCurrentMakesADifference) {
  EXPECT_EQ(CourseCost{}.At(1.0), 1.0);
}

}  // namespace
}  // namespace limpet
