// SPDX-License-Identifier: MIT
#include "limpet/planning/fence_allowance.hpp"

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

TEST(FenceAllowance, IsThePilotsAloneWhereThePlaceIsKnownExactly) {
  const FenceAllowance fences(OpenArea(3.0), kPilot, kRadius);
  EXPECT_EQ(fences.For(kMiddle, Meters(0.0), kPilot), kPilot);
}

TEST(FenceAllowance, IsThreeSigmasOfThePlaceMore) {
  const FenceAllowance fences(OpenArea(3.0), kPilot, kRadius);
  EXPECT_NEAR(fences.For(kMiddle, Meters(0.5), kPilot).value(), 0.4 + 1.5, 1e-9);
  EXPECT_NEAR(fences.For(kMiddle, Meters(0.52), kPilot).value(), 0.4 + 1.75, 1e-9) << "rounded up";
}

TEST(FenceAllowance, TakesNoGroundOfTheAreaAway) {
  EXPECT_LE(FenceAllowance(OpenArea(2.0), kPilot, kRadius).most(), Meters(2.0));
  SurveyArea area = OpenArea(2.0);
  area.operating_region = PlacesText({{-1, -3}, {23, -3}, {23, 23}, {-1, 23}});
  EXPECT_LE(FenceAllowance(area, kPilot, kRadius).most(), Meters(1.0));
}

TEST(FenceAllowance, LeavesRoomToTurnBetweenZones) {
  EXPECT_GT(FenceAllowance(OpenArea(3.0), kPilot, kRadius).most(), Meters(2.5));
  const Meters most = FenceAllowance(NarrowArea(), kPilot, kRadius).most();
  EXPECT_GT(most, Meters(0.5));
  EXPECT_LE(most, Meters(1.5)) << "half of the 9 m less the turn";
}

TEST(FenceAllowance, LeavesAVehicleNearTheBorderItsTurn) {
  const FenceAllowance fences(OpenArea(3.0), kPilot, kRadius);
  const Pose2 near_corner{.north = 0.2, .east = 0.2, .yaw = 0.0};
  EXPECT_LT(fences.For(near_corner, Meters(1.0), kPilot), Meters(0.7));
  EXPECT_GT(fences.For(kMiddle, Meters(1.0), kPilot), Meters(2.5));
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
    const Meters allowance = fences.For(here, Meters(random.Uniform(0.0, 1.0)), kPilot);
    const Region region(area, allowance);
    EXPECT_TRUE(region.Contains(here));
    EXPECT_TRUE(region.IsRecoverable(here, kRadius));
    tight += allowance < fences.most() ? 1 : 0;
  }
  EXPECT_GT(tight, 50);
}

TEST(FenceAllowance, DoesNotFollowEveryChangeOfTheSigma) {
  const FenceAllowance fences(OpenArea(3.0), kPilot, kRadius);
  const Meters held = fences.For(kMiddle, Meters(0.5), kPilot);
  EXPECT_EQ(fences.For(kMiddle, Meters(0.42), held), held);
  EXPECT_LT(fences.For(kMiddle, Meters(0.3), held), held);
}

}  // namespace
}  // namespace limpet
