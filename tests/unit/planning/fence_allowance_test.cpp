// SPDX-License-Identifier: MIT
#include "limpet/planning/fence_allowance.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

constexpr Meters kPilot{0.4}, kRadius{3.0};
const Pose2 kMiddle{.north = 10.0, .east = 10.0, .yaw = 0.0};

SurveyArea OpenArea(double margin) {
  return {.north_min = 0.0,
          .north_max = 20.0,
          .east_min = 0.0,
          .east_max = 20.0,
          .margin = margin,
          .object_height_max = 2.0};
}

/// 20 m wide, but for two piers that leave 9 m between them, halfway.
SurveyArea NarrowArea() {
  SurveyArea area = AreaWithin({{0, 0}, {40, 0}, {40, 20}, {0, 20}});
  area.margin = 3.0;
  area.keep_out = PlacesText({{19, -2}, {21, -2}, {21, 5.5}, {19, 5.5}}) +
                  PlacesText({{19, 14.5}, {21, 14.5}, {21, 22}, {19, 22}});
  return area;
}

KeptOff Kept(const FenceAllowance& fences, const Pose2& here, double sigma,
             const KeptOff& held = {.border = kPilot, .zones = kPilot}) {
  constexpr Meters kSight{2.5};
  return fences.For(here, Meters(sigma), held, kSight);
}

TEST(FenceAllowance, IsThePilotsAloneWhereThePlaceIsKnownExactly) {
  const FenceAllowance fences(OpenArea(3.0), kPilot, kRadius);
  EXPECT_EQ(Kept(fences, kMiddle, 0.0), (KeptOff{.border = kPilot, .zones = kPilot}));
}

TEST(FenceAllowance, IsThreeSigmasOfThePlaceMore) {
  const FenceAllowance fences(OpenArea(3.0), kPilot, kRadius);
  EXPECT_NEAR(Kept(fences, kMiddle, 0.5).border.value(), 0.4 + 1.5, 1e-9);
  EXPECT_NEAR(Kept(fences, kMiddle, 0.52).border.value(), 0.4 + 1.75, 1e-9) << "rounded up";
}

TEST(FenceAllowance, TakesNoGroundOfTheAreaAway) {
  EXPECT_LE(FenceAllowance(OpenArea(2.0), kPilot, kRadius).most().border, Meters(2.0));
  SurveyArea area = OpenArea(2.0);
  area.operating_region = PlacesText({{-1, -3}, {23, -3}, {23, 23}, {-1, 23}});
  EXPECT_LE(FenceAllowance(area, kPilot, kRadius).most().border, Meters(1.0));
}

TEST(FenceAllowance, LeavesRoomToTurnBetweenZones) {
  EXPECT_GT(FenceAllowance(OpenArea(3.0), kPilot, kRadius).most().border, Meters(2.5));
  const KeptOff both = FenceAllowance(NarrowArea(), kPilot, kRadius).most();
  for (const Meters most : {both.border, both.zones}) {
    EXPECT_GT(most, Meters(0.5));
    EXPECT_LE(most, Meters(1.5)) << "half of the 9 m less the turn";
  }
}

/// 30 m square with nine posts of 1.4 m, 9 m apart.
SurveyArea AreaWithPosts() {
  SurveyArea area = AreaWithin({{-15, -15}, {15, -15}, {15, 15}, {-15, 15}});
  area.margin = 2.0;
  std::string posts;
  for (const double north : {-9.0, 0.0, 9.0}) {
    for (const double east : {-9.0, 0.0, 9.0}) {
      posts += PlacesText({{north - 0.7, east - 0.7},
                           {north + 0.7, east - 0.7},
                           {north + 0.7, east + 0.7},
                           {north - 0.7, east + 0.7}});
    }
  }
  area.keep_out = posts;
  return area;
}

TEST(FenceAllowance, KeepsAsFarOffPostsAsATurnBetweenThemLeaves) {
  const FenceAllowance fences(AreaWithPosts(), kPilot, kRadius);
  EXPECT_GE(fences.most().zones, Meters(0.6)) << "7.6 m between two, less the turn";
  EXPECT_LE(fences.most().zones, Meters(0.8));
  const Pose2 between{.north = 4.5, .east = 4.5, .yaw = 0.0};
  EXPECT_GT(Kept(fences, between, 0.5).zones, Meters(0.6));
  EXPECT_EQ(Kept(fences, between, 0.0).zones, kPilot);
}

TEST(FenceAllowance, KeepsThreeSigmasOffAZoneThatStandsAlone) {
  SurveyArea area = OpenArea(1.0);
  area.keep_out = PlacesText({{9, 9}, {11, 9}, {11, 11}, {9, 11}});
  const FenceAllowance fences(area, kPilot, kRadius);
  const Pose2 beside{.north = 3.5, .east = 3.5, .yaw = 1.57};
  EXPECT_LE(fences.most().border, Meters(1.0)) << "what the margin leaves";
  EXPECT_NEAR(Kept(fences, beside, 0.5).zones.value(), 0.4 + 1.5, 1e-9);
  const KeptOff seen = fences.For(beside, Meters(0.5), {}, Meters(1.5));
  EXPECT_LE(seen.zones, Meters(1.5)) << "the ground along the zone is to be seen";
  const Region region(area, Kept(fences, beside, 0.5), {});
  EXPECT_FALSE(region.Contains(PlanePoint(7.2, 10.0)));
  EXPECT_TRUE(region.Contains(PlanePoint(7.0, 10.0)));
  EXPECT_TRUE(region.Contains(PlanePoint(-0.3, 10.0)));
}

TEST(FenceAllowance, LeavesAVehicleNearTheBorderItsTurn) {
  const FenceAllowance fences(OpenArea(3.0), kPilot, kRadius);
  const Pose2 near_corner{.north = 0.2, .east = 0.2, .yaw = 0.0};
  EXPECT_LT(Kept(fences, near_corner, 1.0).border, Meters(0.7));
  EXPECT_GT(Kept(fences, kMiddle, 1.0).border, Meters(2.5));
}

/// At once, or after an arc and a straight line.
bool GetsToATurn(const Region& region, const Pose2& here) {
  for (double turned = -3.0; turned <= 3.01; turned += 0.1) {
    const PathSegment arc{.curvature = std::copysign(1.0 / kRadius.value(), turned),
                          .length = std::abs(turned) * kRadius.value()};
    const Pose2 ahead = Advance(here, arc);
    if (!region.Contains(here, arc)) continue;
    for (double length = 0.0; length <= 25.0; length += 0.25) {
      const PathSegment line{.curvature = 0.0, .length = length};
      if (!region.Contains(ahead, line)) break;
      if (region.IsRecoverable(Advance(ahead, line), kRadius)) return true;
    }
  }
  return false;
}

/// Of two turning circles one is near the border, the other one near a zone.
TEST(FenceAllowance, LeavesAWayToTheSameTurnOffBordersAndOffZones) {
  SurveyArea area = OpenArea(3.0);
  area.keep_out = PlacesText({{9, 9}, {11, 9}, {11, 11}, {9, 11}});
  const FenceAllowance fences(area, kPilot, kRadius);
  const Region widest(area, kPilot);
  Random random(3, "sides");
  int tight = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose2 here{random.Uniform(-3.0, 23.0), random.Uniform(-3.0, 23.0),
                     random.Uniform(-3.1, 3.1)};
    if (!widest.Contains(here) || !widest.IsRecoverable(here, kRadius)) continue;
    const KeptOff kept = Kept(fences, here, random.Uniform(0.0, 1.0));
    const Region region(area, kept, {});
    EXPECT_TRUE(region.Contains(here));
    EXPECT_TRUE(GetsToATurn(region, here));
    tight += kept.zones < fences.most().zones ? 1 : 0;
  }
  EXPECT_GT(tight, 50);
}

/// A basin of 50 x 42 m; between a pier in it and its northern quay 7.5 m are left.
SurveyArea BasinWithPier() {
  SurveyArea area = AreaWithin({{-20, -25}, {22, -25}, {22, 25}, {-20, 25}});
  area.margin = 1.5;
  area.keep_out = PlacesText({{6, -13}, {16, -13}, {16, -10}, {6, -10}});
  return area;
}

TEST(FenceAllowance, HoldsOnAWayThroughAPassageThatIsTooNarrowToTurnIn) {
  const SurveyArea area = BasinWithPier();
  const FenceAllowance fences(area, kPilot, kRadius);
  const Pose2 along{.north = 20.0, .east = -11.5, .yaw = 1.57};
  const KeptOff kept = Kept(fences, along, 0.5);
  EXPECT_NEAR(kept.zones.value(), 0.4 + 1.5, 1e-9);
  const Region region(area, kept, {});
  EXPECT_FALSE(region.IsRecoverable(along, kRadius));
  const Pose2 behind = Advance(along, {.curvature = 0.0, .length = 8.0});
  EXPECT_TRUE(region.Contains(along, {.curvature = 0.0, .length = 8.0}));
  EXPECT_TRUE(region.IsRecoverable(behind, kRadius));
}

TEST(FenceAllowance, FallsForAVehicleThatComesUponAPierHeadOn) {
  const FenceAllowance fences(BasinWithPier(), kPilot, kRadius);
  const Pose2 head_on{.north = 3.0, .east = -11.5, .yaw = 0.0};
  EXPECT_EQ(Kept(fences, head_on, 0.5).zones, kPilot);
}

/// Else a pilot's error of centimetres at the end of a lane would leave it nothing to fly.
TEST(FenceAllowance, NeverLeavesTheVehicleOutsideOrWithoutATurn) {
  const SurveyArea area = OpenArea(3.0);
  const FenceAllowance fences(area, kPilot, kRadius);
  const Region widest(area, kPilot);
  Random random(2, "fences");
  int tight = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose2 here{random.Uniform(-3.0, 23.0), random.Uniform(-3.0, 23.0),
                     random.Uniform(-3.1, 3.1)};
    if (!widest.Contains(here) || !widest.IsRecoverable(here, kRadius)) continue;
    const KeptOff allowance = Kept(fences, here, random.Uniform(0.0, 1.0));
    const Region region(area, allowance, {});
    EXPECT_TRUE(region.Contains(here));
    EXPECT_TRUE(region.IsRecoverable(here, kRadius));
    tight += allowance.border < fences.most().border ? 1 : 0;
  }
  EXPECT_GT(tight, 50);
}

TEST(FenceAllowance, DoesNotFollowEveryChangeOfTheSigma) {
  const FenceAllowance fences(OpenArea(3.0), kPilot, kRadius);
  const KeptOff held = Kept(fences, kMiddle, 0.5);
  EXPECT_EQ(Kept(fences, kMiddle, 0.42, held), held);
  EXPECT_LT(Kept(fences, kMiddle, 0.3, held).border, held.border);
}

}  // namespace
}  // namespace limpet
