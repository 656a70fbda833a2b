// SPDX-License-Identifier: MIT
#include "behaviors/BHV_HoldAltitude.hpp"

#include <gtest/gtest.h>

#include "tests/unit/behaviors/every_behavior.hpp"

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

INSTANTIATE_TYPED_TEST_SUITE_P(BhvHoldAltitude, EveryBehavior, BHV_HoldAltitude);

}  // namespace
}  // namespace limpet
