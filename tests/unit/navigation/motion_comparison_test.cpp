// SPDX-License-Identifier: MIT
#include "estimation/navigation/motion_comparison.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using Vector2d = Eigen::Vector2d;

class MotionComparisonTest : public ::testing::Test {
 protected:
  /// For `seconds` one sensor says `way` each tenth of a second, and the other `other`.
  void Go(double seconds, const Vector2d& way, const Vector2d& other) {
    for (int i = 0; i < std::lround(10.0 * seconds); ++i, t_ += 0.1)
      comparison_.Add(t_, way, other);
  }
  double t_ = 100.0;
  MotionComparison comparison_{{.stretch = Seconds(2.0), .least = 1.0}};
};

TEST_F(MotionComparisonTest, SaysNothingBeforeNineStretchesWithAWay) {
  Go(17.0, {0.1, 0.0}, {0.1, 0.0});
  EXPECT_FALSE(comparison_.ratio());
  Go(60.0, {0.01, 0.0}, {-0.5, 0.0});
  EXPECT_FALSE(comparison_.ratio()) << "the first sensor says that it hardly moved";
  Go(3.0, {0.1, 0.0}, {0.1, 0.0});
  ASSERT_TRUE(comparison_.ratio());
  EXPECT_NEAR((comparison_.ratio()->median_H - Vector2d(1.0, 0.0)).norm(), 0.0, 1e-9);
}

TEST_F(MotionComparisonTest, TellsSignShareAndAngle) {
  const Vector2d way(0.08, 0.06);
  Go(30.0, way, -2.5 * way);
  EXPECT_NEAR((comparison_.ratio()->median_H - Vector2d(-2.5, 0.0)).norm(), 0.0, 1e-9);
  Go(30.0, way, {-0.06, 0.08});  // a quarter turn to starboard of axes ahead and to starboard
  EXPECT_NEAR((comparison_.ratio()->median_H - Vector2d(0.0, 1.0)).norm(), 0.0, 1e-9);
}

TEST_F(MotionComparisonTest, GlitchesTellNothingUntilTheyAreTheRule) {
  Go(30.0, {0.1, 0.0}, {0.1, 0.0});
  Go(8.0, {0.1, 0.0}, {-5.0, 3.0});
  EXPECT_NEAR(comparison_.ratio()->median_H.x(), 1.0, 1e-9);
  Go(4.0, {0.1, 0.0}, {-5.0, 3.0});
  EXPECT_LT(comparison_.ratio()->median_H.x(), -10.0);
}

TEST(MotionComparison, WhatGoesOneWayAndTheOtherByTurnsShowsBesideTheMedian) {
  MotionComparison comparison{{.stretch = Seconds(1.0), .least = 1.0}};
  for (int i = 0; i < 12; ++i)
    comparison.Add(1.0 * i, {1.0, 0.0}, {i % 2 == 0 ? 1.0 : -1.0, 0.0});
  EXPECT_EQ(comparison.ratio()->low_H.x(), -1.0);
  EXPECT_EQ(comparison.ratio()->high_H.x(), 1.0);
}

TEST_F(MotionComparisonTest, APauseEndsAStretchAndWhatIsNoNumberDoesNotCount) {
  for (int i = 0; i < 30; ++i, t_ += 3.0)
    Go(1.5, {0.1, 0.0}, {-0.1, 0.0});
  EXPECT_FALSE(comparison_.ratio());
  Go(30.0, {0.1, 0.0}, {std::numeric_limits<double>::quiet_NaN(), 0.0});
  EXPECT_FALSE(comparison_.ratio());
  comparison_.Add(t_ - 5.0, {0.1, 0.0}, {0.1, 0.0});
  EXPECT_FALSE(comparison_.ratio()) << "time does not run backwards";
}

TEST_F(MotionComparisonTest, NoiseOfAQuarterOfTheLeastWayIsFarFromAnotherMotion) {
  Random random(7);
  for (int run = 0; run < 300; ++run) {
    MotionComparison comparison{{.stretch = Seconds(1.0), .least = 1.0}};
    for (int i = 0; i <= 100; ++i) {
      const Vector2d other(1.0 + random.Normal(0.25), random.Normal(0.25));
      comparison.Add(1.0 * i, {1.0, 0.0}, other);
    }
    ASSERT_TRUE(comparison.ratio());
    EXPECT_NEAR(comparison.ratio()->median_H.x(), 1.0, 0.5);
    EXPECT_NEAR(comparison.ratio()->median_H.y(), 0.0, 0.5);
  }
}

}  // namespace
}  // namespace limpet
