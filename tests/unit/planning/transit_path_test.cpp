// SPDX-License-Identifier: MIT
// The way in of a vehicle that is outside: it ends where the vehicle can go on, and is short.
#include "limpet/planning/transit_path.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/home_path.hpp"

namespace limpet {
namespace {

constexpr Meters kTransitRadius{3.0};
const SurveyArea kTransitArea{
    .north_min = -15.0, .north_max = 15.0, .east_min = -18.0, .east_max = 18.0};

Pose2 OutsidePose(Random& random, const Region& region) {
  while (true) {
    const Pose2 pose{random.Uniform(-90.0, 90.0), random.Uniform(-90.0, 90.0),
                     random.Uniform(-std::numbers::pi, std::numbers::pi)};
    if (region.Outside(pose) > 0.1) return pose;
  }
}

PlanePoint PlaceOf(const Pose2& pose) { return {pose.north, pose.east}; }

TEST(TransitPath, EndsInsideWhereTheVehicleCanGoOn) {
  const Region region(kTransitArea);
  Random random(1, "transit");
  for (int run = 0; run < 200; ++run) {
    const Pose2 start = OutsidePose(random, region);
    const auto option = TransitPath(start, PlaceOf(start), region, kTransitRadius);
    ASSERT_TRUE(option);
    const Pose2 end = option->path.end();
    EXPECT_LE(region.Outside(end), 1e-9);
    EXPECT_TRUE(region.IsRecoverable(end, kTransitRadius));
    EXPECT_TRUE(LeadsInto(region, *option));
    EXPECT_EQ(option->path.start().north, start.north);
    EXPECT_EQ(option->source, "transit");
  }
}

TEST(TransitPath, IsNoShorterThanTheGapAndNotMuchLonger) {
  const Region region(kTransitArea);
  Random random(2, "transit");
  for (int run = 0; run < 200; ++run) {
    const Pose2 start = OutsidePose(random, region);
    const double length = TransitPath(start, PlaceOf(start), region, kTransitRadius)->path.length();
    EXPECT_GE(length, region.Outside(start) - 1e-9);
    // The entry lies a turning radius inside; to turn about costs less than a full turn.
    EXPECT_LE(length,
              std::sqrt(2.0) * (region.Outside(start) + 3.0) + 2.0 * std::numbers::pi * 3.0);
  }
}

TEST(TransitPath, TurnsNoTighterThanTheVehicleCan) {
  const Region region(kTransitArea);
  Random random(3, "transit");
  for (int run = 0; run < 100; ++run) {
    const Pose2 start = OutsidePose(random, region);
    const auto option = TransitPath(start, PlaceOf(start), region, kTransitRadius);
    for (const PathSegment& segment : option->path.segments()) {
      EXPECT_LE(std::abs(segment.curvature), 1.0 / 3.0 + 1e-9);
      EXPECT_GE(segment.length, 0.0);
    }
  }
}

TEST(TransitPath, IsNoneIntoARegionWithoutRoomForATurn) {
  SurveyArea narrow = kTransitArea;
  narrow.north_min = -0.5, narrow.north_max = 0.5, narrow.margin = 0.5;
  EXPECT_FALSE(TransitPath({50.0, 0.0, 0.0}, {50.0, 0.0}, Region(narrow), kTransitRadius));
}

TEST(TransitPath, AWayHomeIsNoWayIn) {
  const Region region(kTransitArea);
  const Option home = HomePath({40.0, 0.0, 0.0}, {0.0, 0.0}, region, kTransitRadius);
  EXPECT_FALSE(LeadsInto(region, home)) << "it may end inside, but the survey is over then";
}

TEST(HomePathProperties, IsAsLongAsItsEstimateSaysAndNeverShorterThanTheLine) {
  const Region region(kTransitArea);
  Random random(4, "home");
  for (int run = 0; run < 100; ++run) {
    const Pose2 start{random.Uniform(-13.0, 13.0), random.Uniform(-16.0, 16.0),
                      random.Uniform(-3.1, 3.1)};
    const double north = random.Uniform(-13.0, 13.0), east = random.Uniform(-16.0, 16.0);
    const Option home = HomePath(start, {north, east}, region, kTransitRadius);
    EXPECT_NEAR(home.estimate, -home.path.length(), 1e-9);
    EXPECT_GE(home.path.length(), std::hypot(north - start.north, east - start.east) - 1e-6);
    EXPECT_NEAR(home.path.end().north, north, 1e-6);
    EXPECT_NEAR(home.path.end().east, east, 1e-6);
    EXPECT_TRUE(MayEndAnywhere(home));
  }
}

}  // namespace
}  // namespace limpet
