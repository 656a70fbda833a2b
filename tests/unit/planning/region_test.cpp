// SPDX-License-Identifier: MIT
#include "limpet/planning/region.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr Meters kTurnRadius{3.0};
const Region kRegion(SurveyArea{-15.0, 15.0, -18.0, 18.0, 2.0, 2.0});

TEST(Region, IsTheAreaAndItsMargin) {
  EXPECT_TRUE(kRegion.Contains(PlanePoint(16.9, 19.9)));
  EXPECT_FALSE(kRegion.Contains(PlanePoint(17.1, 0.0)));
}

TEST(Region, PathsKeepOffAnObstacleThatWasFound) {
  const SurveyArea area{-15.0, 15.0, -18.0, 18.0, 2.0, 2.0};
  const SimplePolygon pile = SimplePolygon::Box({-0.5, -0.5}, {0.5, 0.5});
  const Region region(area, Meters(0.4), {{.polygon = pile, .distance = 1.5}});
  EXPECT_FALSE(region.Contains(PlanePoint(1.9, 0.0)));
  EXPECT_TRUE(region.Contains(PlanePoint(2.1, 0.0)));
  EXPECT_TRUE(region.Contains(PlanePoint(16.5, 0.0)));
  EXPECT_FALSE(region.Contains(PlanePoint(16.7, 0.0)));
  const DubinsPath through({-6.0, 1.0, 0.0}, {{0.0, 12.0}});
  const DubinsPath beside({-6.0, 2.5, 0.0}, {{0.0, 12.0}});
  EXPECT_TRUE(region.EntersZone(through));
  EXPECT_FALSE(region.EntersZone(beside));
  EXPECT_NE(region.obstacle_mark(), Region(area, Meters(0.4)).obstacle_mark());
}

TEST(Region, KeepsOffZonesFartherThanInsideTheBorder) {
  SurveyArea area{-15.0, 15.0, -18.0, 18.0, 2.0, 2.0};
  area.keep_out = PlacesText({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
  const Region region(area, {.border = Meters(0.4), .zones = Meters(1.9)}, {});
  EXPECT_FALSE(region.Contains(PlanePoint(2.3, 0.0)));
  EXPECT_TRUE(region.Contains(PlanePoint(2.5, 0.0)));
  EXPECT_TRUE(region.Contains(PlanePoint(16.5, 0.0)));
  EXPECT_FALSE(region.Contains(PlanePoint(16.7, 0.0)));
  EXPECT_NEAR(region.ZoneClearance({3.0, 0.0}), 3.0 - 0.5 - 1.9, 1e-9);
  EXPECT_GT(kRegion.ZoneClearance({0.0, 0.0}), 1e9) << "without any";
}

TEST(Region, NoticesAnArcThatLeavesAndComesBack) {
  // Heading north-east 1 m from the northern border: the bulge of the arc is outside, its end not.
  const Pose2 from{16.5, 0.0, 0.25 * std::numbers::pi};
  const PathSegment arc{.curvature = 1.0 / 3.0, .length = 3.0 * 0.5 * std::numbers::pi};
  EXPECT_TRUE(kRegion.Contains(Advance(from, arc)));
  EXPECT_FALSE(kRegion.Contains(from, arc));
}

TEST(Region, AgreesWithSamplingAlongRandomPaths) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const auto pose = [&random] {
      return Pose2{random.Uniform(-17.0, 17.0), random.Uniform(-20.0, 20.0),
                   random.Uniform(-std::numbers::pi, std::numbers::pi)};
    };
    const DubinsPath path = ShortestDubins(pose(), pose(), kTurnRadius);
    bool is_inside = true;
    double farthest = 0.0;
    path.Sample(0.005, [&](const Pose2& at, double) {
      is_inside = is_inside && kRegion.Contains(at);
      farthest = std::max(farthest, kRegion.Outside(at));
    });
    if (farthest == 0.0 || farthest > 1e-4) {  // a touch between samples may go either way
      const bool may_touch = is_inside && !kRegion.Contains(path);
      EXPECT_TRUE(kRegion.Contains(path) == is_inside || may_touch);
    }
  }
}

TEST(Region, IsRecoverableInTheMiddleWithAnyHeading) {
  for (double yaw = -std::numbers::pi; yaw < std::numbers::pi; yaw += 0.1) {
    EXPECT_TRUE(kRegion.IsRecoverable({0.0, 0.0, yaw}, kTurnRadius));
  }
}

TEST(Region, IsNotRecoverableHeadingOutAtTheBorder) {
  EXPECT_FALSE(kRegion.IsRecoverable({16.0, 0.0, 0.0}, kTurnRadius));
  EXPECT_TRUE(kRegion.IsRecoverable({16.0, 0.0, 0.5 * std::numbers::pi}, kTurnRadius));  // along it
}

TEST(Region, FromARecoverableStateThereIsAlwaysAnAllowedMotion) {
  Random random(2);
  Pose2 pose{0.0, 0.0, 0.3};
  for (int i = 0; i < 5000; ++i) {
    std::vector<PathSegment> allowed;
    for (const double curvature : {-1.0 / 3.0, -1.0 / 6.0, 0.0, 1.0 / 6.0, 1.0 / 3.0}) {
      const PathSegment motion{curvature, 2.5};
      if (kRegion.Allows(pose, motion, kTurnRadius)) {
        allowed.push_back(motion);
      }
    }
    ASSERT_FALSE(allowed.empty());
    const PathSegment& motion = allowed[random.Index(allowed.size())];
    ASSERT_TRUE(kRegion.Contains(pose, motion));
    pose = Advance(pose, motion);
  }
}

TEST(Region, LetsADriftedVehicleComeBackButNotGoFarther) {
  const Pose2 outside{17.5, 0.0, 0.0};  // heading out
  EXPECT_TRUE(kRegion.Allows(outside, {1.0 / 3.0, 2.5}, kTurnRadius));
  EXPECT_FALSE(kRegion.Allows(outside, {0.0, 2.5}, kTurnRadius));
}

TEST(Region, ShortestInsideStaysInsideWhereAWordDoes) {
  // Along the border: the shortest word bulges out, another does not.
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Pose2 from{random.Uniform(10.0, 17.0), random.Uniform(-20.0, 20.0),
                     0.5 * std::numbers::pi};
    const Pose2 to{random.Uniform(10.0, 17.0), random.Uniform(-20.0, 20.0),
                   -0.5 * std::numbers::pi};
    bool exists = false;
    for (const DubinsPath& path : AllDubins(from, to, kTurnRadius)) {
      exists = exists || kRegion.Contains(path);
    }
    EXPECT_EQ(kRegion.Contains(kRegion.ShortestInside(from, to, kTurnRadius)), exists);
  }
}

}  // namespace
}  // namespace limpet
