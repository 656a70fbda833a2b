// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ConstantSpeed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::SizeIs;

TEST(BhvConstantSpeed, OverridesALighterBidOnSpeedForItsDuration) {
  HelmFlight flight(
      "Behavior = BHV_Waypoint\n{\n  points = 0,1000\n  speed = 2\n  pwt = 100\n}\n" +
      BehaviorBlock("BHV_ConstantSpeed",
                    "  speed = 0.5\n  pwt = 200\n  duration = 10\n  endflag = OVER = true\n"
                    "  speed_mismatch_var = OFF\n"));
  flight.PlaceAt(0.0, 0.0, 0.0);
  flight.Fly(9.0);
  EXPECT_NEAR(flight.speed(), 0.5, 0.01);
  EXPECT_NEAR(std::stod(flight.Last("OFF")), 0.0, 0.01);
  flight.Fly(9.0);
  EXPECT_THAT(flight.Posts("OVER"), SizeIs(1));
  EXPECT_NEAR(flight.speed(), 2.0, 0.01);
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvConstantSpeed, EveryBehavior, BHV_ConstantSpeed);

}  // namespace
}  // namespace limpet
