// SPDX-License-Identifier: MIT
#include "limpet/tuning/student_t.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(StudentT, IsCauchysDistributionWithOneDegreeOfFreedom) {
  for (const double t : {-30.0, -2.0, -0.3, 0.0, 0.7, 5.0}) {
    EXPECT_NEAR(StudentProbability(t, 1.0), 0.5 + std::atan(t) / std::numbers::pi, 1e-12) << t;
  }
}

TEST(StudentT, HasItsClosedFormWithTwoDegreesOfFreedom) {
  for (const double t : {-8.0, -1.0, 0.0, 0.2, 3.0}) {
    EXPECT_NEAR(StudentProbability(t, 2.0), 0.5 + t / (2.0 * std::sqrt(2.0 + t * t)), 1e-12) << t;
  }
}

TEST(StudentT, HasTheQuantilesOfTheTables) {
  EXPECT_NEAR(StudentQuantile(0.975, 1.0), 12.7062, 1e-4);
  EXPECT_NEAR(StudentQuantile(0.975, 9.0), 2.26216, 1e-5);
  EXPECT_NEAR(StudentQuantile(0.975, 30.0), 2.04227, 1e-5);
  EXPECT_NEAR(StudentQuantile(0.05, 5.0), -2.01505, 1e-5);
  EXPECT_NEAR(StudentQuantile(0.975, 1e6), 1.95996, 1e-5);
}

TEST(StudentT, GivesAMeanItsInterval) {
  const MeanInterval interval = IntervalOf({1.0, 2.0, 3.0, 4.0});
  EXPECT_EQ(interval.mean, 2.5);
  EXPECT_EQ(interval.count, 4U);
  const double half = 3.182446 * std::sqrt(5.0 / 3.0) / 2.0;
  EXPECT_NEAR(*interval.low, 2.5 - half, 1e-5);
  EXPECT_NEAR(*interval.high, 2.5 + half, 1e-5);
  EXPECT_FALSE(IntervalOf({7.0}).low);
}

TEST(StudentT, SaysHowLikelyAMeanDifferenceIsByChance) {
  EXPECT_FALSE(ChanceOfSoGreatAMean({1.0}));
  EXPECT_EQ(ChanceOfSoGreatAMean({0.0, 0.0}), 0.5);
  EXPECT_EQ(ChanceOfSoGreatAMean({1.0, 1.0}), 0.0);
  EXPECT_EQ(ChanceOfSoGreatAMean({-1.0, -1.0}), 1.0);
  // t = 2 / (sqrt(2) / sqrt(2)) = 2 with one degree of freedom.
  EXPECT_NEAR(*ChanceOfSoGreatAMean({1.0, 3.0}), 0.5 - std::atan(2.0) / std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace limpet
