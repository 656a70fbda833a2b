// SPDX-License-Identifier: MIT
#include "limpet/planning/line_of_sight.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kSpeed = 0.5;

/// 10 m north, half a turn to starboard of 3 m radius, 10 m south.
const std::vector<PathSegment> kLanes = {
    {0.0, 10.0}, {1.0 / 3.0, 3.0 * std::numbers::pi}, {0.0, 10.0}};

LineOfSight OnLanes() {
  LineOfSight sight;
  sight.SetPath({0.0, 0.0, 0.0}, kLanes);
  return sight;
}

TEST(LineOfSight, SteersThePathsOwnCourseOnThePath) {
  LineOfSight sight = OnLanes();
  for (double s = 0.0; s < sight.length(); s += 0.1) {
    const Pose2 at = sight.At(s);
    const LineOfSight::Steering steering = sight.Update({at.north, at.east}, kSpeed);
    ASSERT_NEAR(steering.progress, s, 1e-9);
    ASSERT_NEAR(steering.cross_track, 0.0, 1e-9);
    ASSERT_NEAR(WrapAngle(steering.course - at.yaw), 0.0, 1e-9);
  }
}

TEST(LineOfSight, EndsWhereTheSegmentsEnd) {
  const LineOfSight sight = OnLanes();
  const Pose2 end = sight.At(sight.length());
  EXPECT_NEAR(end.north, 0.0, 1e-9);
  EXPECT_NEAR(end.east, 6.0, 1e-9);
  EXPECT_NEAR(end.yaw, std::numbers::pi, 1e-9);
}

TEST(LineOfSight, CallsStarboardOfThePathPositiveAndSteersToPort) {
  LineOfSight sight = OnLanes();
  const LineOfSight::Steering steering = sight.Update({5.0, 0.7}, kSpeed);
  EXPECT_NEAR(steering.cross_track, 0.7, 1e-12);
  EXPECT_NEAR(steering.course, -std::atan(0.7 / 1.5), 1e-12);
}

TEST(LineOfSight, MeasuresCrossTrackExactlyOnArcsOfEitherHand) {
  for (const double curvature : {0.4, -0.4}) {
    LineOfSight sight({.search = Meters(20.0)});
    sight.SetPath({1.0, 2.0, 0.7}, {{curvature, 6.0}});
    const Pose2 at = sight.At(4.0);
    const double starboard = 0.35;
    const LineOfSight::Steering steering = sight.Update(
        {at.north - starboard * std::sin(at.yaw), at.east + starboard * std::cos(at.yaw)}, kSpeed);
    EXPECT_NEAR(steering.progress, 4.0, 1e-9);
    EXPECT_NEAR(steering.cross_track, starboard, 1e-9);
  }
}

TEST(LineOfSight, FeedsForwardTheTurnRateOfAnArc) {
  LineOfSight sight;
  sight.SetPath({0.0, 0.0, 0.0}, {{-1.0 / 3.0, 12.0}});
  const Pose2 at = sight.At(1.5);
  EXPECT_NEAR(sight.Update({at.north, at.east}, kSpeed).turn_rate, -kSpeed / 3.0, 1e-9);
}

TEST(LineOfSight, BeginsToTurnAheadOfAnArc) {
  LineOfSight sight = OnLanes();
  EXPECT_EQ(sight.Update({1.9, 0.0}, kSpeed).turn_rate, 0.0);
  for (double north = 2.0; north < 9.9; north += 0.5)
    (void)sight.Update({north, 0.0}, kSpeed);
  EXPECT_GT(sight.Update({9.9, 0.0}, kSpeed).turn_rate, 0.05);
}

TEST(LineOfSight, NeverGoesBack) {
  LineOfSight sight = OnLanes();
  (void)sight.Update({1.5, 0.0}, kSpeed);
  EXPECT_NEAR(sight.Update({0.5, 0.0}, kSpeed).progress, 1.5, 1e-12);
}

TEST(LineOfSight, FollowsAPathThatCrossesItselfInItsOwnOrder) {
  LineOfSight sight;
  sight.SetPath({0.0, 0.0, 0.0}, {{0.0, 8.0}, {1.0 / 3.0, 4.5 * std::numbers::pi}, {0.0, 8.0}});
  double last = 0.0;
  for (double s = 0.0; s < sight.length(); s += 0.05) {
    const Pose2 at = sight.At(s);
    const double progress = sight.Update({at.north, at.east}, kSpeed).progress;
    ASSERT_NEAR(progress, s, 1e-6);
    ASSERT_GE(progress, last);
    last = progress;
  }
}

TEST(LineOfSight, FollowsMoreThanOneFullCircle) {
  LineOfSight sight;
  sight.SetPath({0.0, 0.0, 0.0}, {{1.0 / 3.0, 15.0 * std::numbers::pi}});
  for (double s = 0.0; s < sight.length(); s += 0.05) {
    const Pose2 at = sight.At(s);
    ASSERT_NEAR(sight.Update({at.north, at.east}, kSpeed).progress, s, 1e-6);
  }
}

TEST(LineOfSight, GoesStraightOnBeyondTheEnd) {
  LineOfSight sight({.search = Meters(100.0)});
  sight.SetPath({0.0, 0.0, 0.0}, {{0.0, 5.0}});
  const LineOfSight::Steering steering = sight.Update({7.0, 0.0}, kSpeed);
  EXPECT_TRUE(steering.has_arrived);
  EXPECT_EQ(steering.progress, 5.0);
  EXPECT_EQ(steering.remaining, 0.0);
  EXPECT_NEAR(steering.course, 0.0, 1e-12);
}

TEST(LineOfSight, NearestPointIsNoFartherThanAnySampleAhead) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    LineOfSight sight({.search = Meters(4.0)});
    sight.SetPath({0.0, 0.0, random.Uniform(-std::numbers::pi, std::numbers::pi)},
                  {{random.Uniform(-0.4, 0.4), 2.0}, {0.0, 1.0}, {random.Uniform(-0.4, 0.4), 3.0}});
    const double north = random.Uniform(-3.0, 3.0);
    const double east = random.Uniform(-3.0, 3.0);
    const Pose2 found = sight.At(sight.Update({north, east}, kSpeed).progress);
    const double distance = std::hypot(north - found.north, east - found.east);
    for (double s = 0.0; s <= 4.0; s += 0.01) {
      const Pose2 at = sight.At(s);
      ASSERT_LE(distance, std::hypot(north - at.north, east - at.east) + 1e-9);
    }
  }
}

}  // namespace
}  // namespace limpet
