// SPDX-License-Identifier: MIT
#include "limpet/core/probability.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/logistic.hpp"

namespace limpet {
namespace {

TEST(LogOddsOf, AreWhatTheLogisticTurnsBack) {
  EXPECT_EQ(LogOddsOf(0.5), 0.0);
  EXPECT_NEAR(LogOddsOf(0.8), std::log(4.0), 1e-15);
  for (const double p : {1e-6, 0.05, 0.3, 0.5, 0.7, 0.99})
    EXPECT_NEAR(Logistic(LogOddsOf(p)), p, 1e-15);
}

TEST(LogOddsOf, AreInfiniteForWhatIsCertain) {
  EXPECT_EQ(LogOddsOf(1.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(LogOddsOf(0.0), -std::numeric_limits<double>::infinity());
}

TEST(LogOddsOf, StayWithinWhatIsCredible) {
  const Interval credible{.low = 0.05, .high = 0.95};
  EXPECT_EQ(LogOddsOf(0.3, credible), LogOddsOf(0.3));
  EXPECT_EQ(LogOddsOf(0.0, credible), LogOddsOf(0.05));
  EXPECT_EQ(LogOddsOf(1.0, credible), LogOddsOf(0.95));
}

TEST(StandardNormal, HasTheSharesOfTheTables) {
  EXPECT_EQ(StandardNormalShareBelow(0.0), 0.5);
  EXPECT_NEAR(StandardNormalShareBelow(1.0), 0.8413447460685429, 1e-15);
  EXPECT_NEAR(StandardNormalShareBelow(-1.959963984540054), 0.025, 1e-15);
  EXPECT_NEAR(StandardNormalShareBelow(-10.0) / 7.619853024160527e-24, 1.0, 1e-12);
}

TEST(StandardNormal, HasTheSharesSlopeForItsDensity) {
  constexpr double kStep = 1e-5;
  for (const double z : {-3.0, -0.4, 0.0, 1.0, 2.5}) {
    const double slope =
        (StandardNormalShareBelow(z + kStep) - StandardNormalShareBelow(z - kStep)) / (2.0 * kStep);
    EXPECT_NEAR(slope, StandardNormalDensity(z), 1e-9) << z;
  }
}

TEST(NormalShareBelow, CountsTheOffsetInStandardDeviations) {
  EXPECT_NEAR(NormalShareBelow(3.0, 4.0), StandardNormalShareBelow(1.5), 1e-15);
  EXPECT_NEAR(NormalShareBelow(-0.2, 0.01), StandardNormalShareBelow(-2.0), 1e-15);
}

TEST(NormalShareBelow, IsAStepWithoutVariance) {
  EXPECT_EQ(NormalShareBelow(1e-9, 0.0), 1.0);
  EXPECT_EQ(NormalShareBelow(-1e-9, 0.0), 0.0);
}

TEST(NormalCost, IsMinusTwiceTheDensitysLogarithm) {
  EXPECT_NEAR(NormalCost({.distance2 = 1.7 * 1.7, .log_determinant = 0.0, .dimensions = 1}),
              -2.0 * std::log(StandardNormalDensity(1.7)), 1e-14);
  // Independent variables' costs add.
  const double variance = 0.3, off = 0.5;
  const double one = NormalCost(
      {.distance2 = off * off / variance, .log_determinant = std::log(variance), .dimensions = 1});
  EXPECT_NEAR(NormalCost({.distance2 = 3.0 * off * off / variance,
                          .log_determinant = 3.0 * std::log(variance),
                          .dimensions = 3}),
              3.0 * one, 1e-13);
  EXPECT_NEAR(NormalCost({.distance2 = 0.0, .log_determinant = 0.0, .dimensions = 3}),
              3.0 * std::log(2.0 * std::numbers::pi), 1e-15);
}

}  // namespace
}  // namespace limpet
