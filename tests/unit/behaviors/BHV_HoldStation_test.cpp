// SPDX-License-Identifier: MIT
#include "behaviors/BHV_HoldStation.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

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

INSTANTIATE_TYPED_TEST_SUITE_P(BhvHoldStation, EveryBehavior, BHV_HoldStation);

}  // namespace
}  // namespace limpet
