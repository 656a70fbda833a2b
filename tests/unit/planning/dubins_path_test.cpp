// SPDX-License-Identifier: MIT
#include "limpet/planning/dubins_path.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr Meters kCurveRadius{3.0};

Pose2 RandomPose(Random& random, double extent) {
  return {random.Uniform(-extent, extent), random.Uniform(-extent, extent),
          random.Uniform(-std::numbers::pi, std::numbers::pi)};
}

void ExpectSamePose(const Pose2& a, const Pose2& b, double tolerance = 1e-6) {
  EXPECT_NEAR(a.north, b.north, tolerance);
  EXPECT_NEAR(a.east, b.east, tolerance);
  EXPECT_NEAR(WrapAngle(a.yaw - b.yaw), 0.0, tolerance);
}

TEST(Advance, TurnsToStarboardWithPositiveCurvature) {
  // Heading north, a quarter turn to starboard of radius 3 ends 3 m north and 3 m east, heading
  // east.
  ExpectSamePose(
      Advance({0.0, 0.0, 0.0}, {.curvature = 1.0 / 3.0, .length = 1.5 * std::numbers::pi}),
      {3.0, 3.0, 0.5 * std::numbers::pi}, 1e-12);
}

TEST(Advance, IsStraightWithoutCurvature) {
  ExpectSamePose(Advance({1.0, 2.0, 0.5 * std::numbers::pi}, {.curvature = 0.0, .length = 4.0}),
                 {1.0, 6.0, 0.5 * std::numbers::pi}, 1e-12);
}

TEST(ShortestDubins, EndsWhereItIsAskedTo) {
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Pose2 from = RandomPose(random, 10.0), to = RandomPose(random, 10.0);
    ExpectSamePose(ShortestDubins(from, to, kCurveRadius).end(), to);
  }
}

TEST(AllDubins, EveryWordEndsWhereItIsAskedTo) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Pose2 from = RandomPose(random, 5.0), to = RandomPose(random, 5.0);
    for (const DubinsPath& path : AllDubins(from, to, kCurveRadius)) {
      ExpectSamePose(path.end(), to);
    }
  }
}

TEST(AllDubins, HoldsAllSixWordsForNearPoses) {
  EXPECT_EQ(AllDubins({0.0, 0.0, 0.0}, {13.0, 1.0, 0.1}, kCurveRadius).size(), 4U);
  EXPECT_GE(AllDubins({0.0, 0.0, 0.0}, {1.0, 1.0, 2.0}, kCurveRadius).size(), 4U);
}

TEST(ShortestDubins, IsNeverShorterThanTheStraightLineNorLongerThanAnyWord) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Pose2 from = RandomPose(random, 10.0), to = RandomPose(random, 10.0);
    const double length = ShortestDubins(from, to, kCurveRadius).length();
    EXPECT_GE(length, Distance(from, to) - 1e-9);
    for (const DubinsPath& path : AllDubins(from, to, kCurveRadius)) {
      EXPECT_LE(length, path.length() + 1e-9);
    }
  }
}

TEST(ShortestDubins, IsAsLongBackwardsInTheMirror) {
  // Reversing both headings and swapping the ends gives the same curve, flown the other way.
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const Pose2 from = RandomPose(random, 8.0), to = RandomPose(random, 8.0);
    const Pose2 back_from{to.north, to.east, to.yaw + std::numbers::pi};
    const Pose2 back_to{from.north, from.east, from.yaw + std::numbers::pi};
    EXPECT_NEAR(ShortestDubins(from, to, kCurveRadius).length(),
                ShortestDubins(back_from, back_to, kCurveRadius).length(), 1e-6);
  }
}

TEST(ShortestDubins, DoesNotLoopForARoundingErrorOfHeading) {
  for (const double error : {-1e-16, 1e-16, -1e-12, 1e-12, -4e-16}) {
    const DubinsPath path = ShortestDubins({0.0, 0.0, 0.0}, {10.0, 0.0, error}, kCurveRadius);
    EXPECT_NEAR(path.length(), 10.0, 1e-6) << error;
  }
}

TEST(ShortestDubins, DoesNotLoopAfterARandomLineOrArc) {
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const Pose2 from = RandomPose(random, 20.0);
    const double curvature = (static_cast<double>(random.Index(3)) - 1.0) / kCurveRadius.value();
    const double length = random.Uniform(0.1, 3.0);
    const Pose2 to = Advance(from, {.curvature = curvature, .length = length});
    EXPECT_NEAR(ShortestDubins(from, to, kCurveRadius).length(), length, 1e-5);
  }
}

TEST(ShortestDubins, TurnsNoTighterThanItsRadius) {
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    for (const PathSegment& segment :
         ShortestDubins(RandomPose(random, 8.0), RandomPose(random, 8.0), kCurveRadius)
             .segments()) {
      EXPECT_LE(std::abs(segment.curvature), 1.0 / kCurveRadius.value() + 1e-12);
    }
  }
}

TEST(DubinsPath, IsContinuous) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const DubinsPath path =
        ShortestDubins(RandomPose(random, 8.0), RandomPose(random, 8.0), kCurveRadius);
    for (double s = 0.0; s + 0.01 <= path.length(); s += 0.01) {
      const Pose2 a = path.At(s), b = path.At(s + 0.01);
      ASSERT_NEAR(Distance(a, b), 0.01, 1e-4);
      ASSERT_LE(std::abs(WrapAngle(b.yaw - a.yaw)), 0.01 / kCurveRadius.value() + 1e-9);
    }
  }
}

TEST(DubinsPath, PrefixEndsWhereThePathIsThen) {
  const DubinsPath path = ShortestDubins({0.0, 0.0, 0.0}, {5.0, 9.0, 2.0}, kCurveRadius);
  for (double s = 0.0; s < path.length(); s += 0.37) {
    const DubinsPath prefix = path.Prefix(s);
    EXPECT_NEAR(prefix.length(), s, 1e-9);
    ExpectSamePose(prefix.end(), path.At(s), 1e-9);
  }
}

TEST(DubinsPath, SamplesAgreeWithAt) {
  const DubinsPath path = ShortestDubins({0.0, 0.0, 0.0}, {5.0, 9.0, 2.0}, kCurveRadius);
  double last = -1.0;
  path.Sample(0.5, [&](const Pose2& pose, double s) {
    ExpectSamePose(pose, path.At(s), 1e-9);
    EXPECT_GT(s, last);
    last = s;
  });
  EXPECT_DOUBLE_EQ(last, path.length());
}

TEST(DubinsPath, SurvivesTheMessageToThePilot) {
  const DubinsPath path = ShortestDubins({1.0, 2.0, 0.3}, {5.0, 9.0, 2.0}, kCurveRadius);
  const HelmPath message = ToHelmPath(path, 7, "cover");
  EXPECT_EQ(message.id, 7);
  EXPECT_EQ(message.purpose, "cover");
  const DubinsPath heard({message.north, message.east, message.yaw}, message.segments);
  ExpectSamePose(heard.end(), path.end(), 1e-12);
}

}  // namespace
}  // namespace limpet
