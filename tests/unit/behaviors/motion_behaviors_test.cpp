// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "behaviors/BHV_ConstantDepth.hpp"
#include "behaviors/BHV_FollowPath.hpp"
#include "behaviors/BHV_HoldAltitude.hpp"
#include "behaviors/BHV_HoldStation.hpp"

namespace limpet {
namespace {

VehicleState At(double time, double down, std::optional<double> altitude) {
  VehicleState state;
  state.now = Seconds(time);
  state.nav.down = down;
  state.nav.altitude = altitude;
  return state;
}

TEST(BhvHoldAltitude, AsksForTheDepthThatLeavesTheAltitude) {
  BHV_HoldAltitude behavior({});
  behavior.Start(At(0.0, 3.0, 4.5));
  EXPECT_DOUBLE_EQ(behavior.Move(At(0.0, 3.0, 4.5)).depth->summit, 3.5);
}

TEST(BhvHoldAltitude, HasNoOpinionBeforeTheFirstBottomLock) {
  BHV_HoldAltitude behavior({});
  behavior.Start(At(0.0, 3.0, {}));
  const MotionBid bid = behavior.Move(At(1.0, 3.0, {}));
  EXPECT_FALSE(bid.depth.has_value());
  EXPECT_EQ(bid.warning->id.name(), "ALTITUDE_LOST");
}

TEST(BhvHoldAltitude, RemembersALostSeabedForAWhileOnly) {
  BHV_HoldAltitude behavior({});
  behavior.Start(At(0.0, 3.0, 4.5));
  static_cast<void>(behavior.Move(At(0.0, 3.0, 4.5)));
  EXPECT_TRUE(behavior.Move(At(100.0, 3.0, {})).depth.has_value())
      << "the rule dvl_lost acts first";
  EXPECT_FALSE(behavior.Move(At(121.0, 3.0, {})).depth.has_value());
}

TEST(BhvHoldAltitude, NeverAsksToFlyAboveTheSurface) {
  BHV_HoldAltitude behavior({});
  behavior.Start(At(0.0, 0.5, 2.0));
  EXPECT_DOUBLE_EQ(behavior.Move(At(0.0, 0.5, 2.0)).depth->summit, 0.0);
}

TEST(BhvFollowPath, PassesOnTheGuidanceAtSurveySpeed) {
  BHV_FollowPath behavior({});
  VehicleState state;
  state.guidance = Guidance{.course = 1.2, .turn_rate = 0.1};
  const MotionBid bid = behavior.Move(state);
  EXPECT_DOUBLE_EQ(bid.course->summit, 1.2);
  EXPECT_DOUBLE_EQ(*bid.turn_rate, 0.1);
  EXPECT_DOUBLE_EQ(bid.speed->summit, 0.5);
}

TEST(BhvFollowPath, HasNoOpinionWithoutAPath) {
  BHV_FollowPath behavior({});
  EXPECT_FALSE(behavior.Move(VehicleState{}).course.has_value());
}

TEST(BhvHoldStation, KeepsTheHeadingAtWhichItBegan) {
  BHV_HoldStation behavior({});
  VehicleState state;
  state.nav.yaw = 0.7;
  behavior.Start(state);
  state.nav.yaw = 0.9;
  EXPECT_DOUBLE_EQ(behavior.Move(state).course->summit, 0.7);
  EXPECT_DOUBLE_EQ(behavior.Move(state).speed->summit, 0.0);
}

/// A vehicle that heads north and is carried east at 0.2 m/s for `seconds`.
MotionBid CarriedEast(BHV_HoldStation& behavior, double seconds, double jump = 0.0) {
  VehicleState state;
  state.nav.v = 0.2;
  behavior.Start(state);
  MotionBid bid;
  for (int i = 1; i <= static_cast<int>(seconds * 10.0); ++i) {
    state.now = Seconds(0.1 * i);
    state.nav.east = 0.02 * i + (i > 5 ? jump : 0.0);
    bid = behavior.Move(state);
  }
  return bid;
}

TEST(BhvHoldStation, GoesBackWhenCarriedOutOfItsRadius) {
  BHV_HoldStation behavior({});
  const MotionBid bid = CarriedEast(behavior, 6.0);
  EXPECT_NEAR(bid.course->summit, -0.5 * std::numbers::pi, 1e-9);
  EXPECT_GT(bid.speed->summit, 0.2);
}

TEST(BhvHoldStation, StopsAgainNearItsStation) {
  BHV_HoldStation behavior({});
  static_cast<void>(CarriedEast(behavior, 6.0));
  VehicleState state;
  state.nav.yaw = -0.5 * std::numbers::pi;
  state.nav.u = 0.3;
  MotionBid bid;
  for (int i = 1; i <= 40; ++i) {
    state.now = Seconds(6.0 + 0.1 * i);
    bid = behavior.Move(state);
  }
  EXPECT_DOUBLE_EQ(bid.speed->summit, 0.0);
  EXPECT_DOUBLE_EQ(bid.course->summit, -0.5 * std::numbers::pi);
}

TEST(BhvHoldStation, DoesNotMoveForAFixThatMovesTheEstimate) {
  BHV_HoldStation behavior({});
  EXPECT_DOUBLE_EQ(CarriedEast(behavior, 2.0, 5.0).speed->summit, 0.0);
}

TEST(BhvHoldStation, GoesHomeWhenAFixShowsThatItIsElsewhere) {
  BHV_HoldStation behavior({.station = "home"});
  VehicleState state;
  state.home = HomePoint{.north = 3.0, .east = -2.0};
  state.nav.north = 3.2, state.nav.east = -2.0;
  behavior.Start(state);
  EXPECT_DOUBLE_EQ(behavior.Move(state).speed->summit, 0.0);
  state.nav.east = 2.0;  // a fix: carried off without noticing
  const MotionBid bid = behavior.Move(state);
  EXPECT_NEAR(bid.course->summit, std::atan2(-4.0, -0.2), 1e-9);
  EXPECT_GT(bid.speed->summit, 0.2);
}

TEST(BhvHoldStation, StaysWhereItIsUntilHomeIsKnown) {
  BHV_HoldStation behavior({.station = "home"});
  VehicleState state;
  state.nav.north = 40.0;
  behavior.Start(state);
  EXPECT_DOUBLE_EQ(behavior.Move(state).speed->summit, 0.0);
}

TEST(BhvConstantDepth, RefusesADepthBeyondItsRange) {
  ConfigBlock block{
      .name = "BHV_ConstantDepth", .where = {}, .entries = {{"depth", "7000", {"x.bhv", 4}}}};
  EXPECT_THROW(static_cast<void>(ReadParams<BHV_ConstantDepth::Params>(block)), ConfigError);
}

}  // namespace
}  // namespace limpet
