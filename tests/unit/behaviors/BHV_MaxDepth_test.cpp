// SPDX-License-Identifier: MIT
#include "behaviors/BHV_MaxDepth.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

TEST(BhvMaxDepth, HoldsTheVehicleAboveItsDepthAndMindsNoOtherDepth) {
  HelmFlight flight(Dive() + BehaviorBlock("BHV_MaxDepth",
                                           "  max_depth = 8\n  tolerance = 1\n  pwt = 200\n"
                                           "  depth_slack_var = SLACK\n"));
  flight.Fly(60.0);
  EXPECT_NEAR(flight.depth(), 8.0, 1e-6);
  EXPECT_NEAR(std::stod(flight.Last("SLACK")), 0.0, 1e-6);
  HelmFlight shallow(BehaviorBlock("BHV_ConstantDepth", "  depth = 3\n") +
                     BehaviorBlock("BHV_MaxDepth", "  max_depth = 8\n  pwt = 200\n"));
  shallow.Fly(30.0);
  EXPECT_NEAR(shallow.depth(), 3.0, 1e-6);
}

/// What a stock helm's domain of 5 m steps would be told to go to, 5 m deep over 25 m of water.
double DepthAtPoints(const std::string& behaviors) {
  BehaviorHost host({ParseBehaviors(behaviors, "points.bhv")});
  MotionDomain domain;
  domain.depth = MotionAxis{.low = 0.0, .high = 100.0, .points = 21};
  MotionArbiter arbiter(domain, {}, true);
  VehicleState state;
  state.domain = domain;
  state.nav.down = 5.0;
  state.nav.altitude = 20.0;
  state.heard = &host.heard();
  static_cast<void>(host.Update(state));
  return arbiter.Decide(host.running(), state).depth.value_or(-1.0);
}

TEST(DepthAtPoints, IsNoneThatASafetyBehaviorForbids) {
  const std::string deep = BehaviorBlock("BHV_ConstantDepth", "  depth = 30\n");
  const auto above_seabed = [](const std::string& weight) {
    return BehaviorBlock("BHV_MinAltitudeX", "  min_altitude = 2.4\n  pwt = " + weight + "\n");
  };
  EXPECT_EQ(DepthAtPoints(deep + above_seabed("1000")), 20.0);
  EXPECT_EQ(DepthAtPoints(deep + above_seabed("100")), 20.0) << "of one weight, too";
  const auto at_most = [](const std::string& lines) {
    return BehaviorBlock("BHV_MaxDepth", "  pwt = 200\n  tolerance = 1\n" + lines);
  };
  EXPECT_EQ(DepthAtPoints(deep + at_most("  max_depth = 7.6\n")), 5.0);
  EXPECT_EQ(DepthAtPoints(deep + at_most("  max_depth = 8\n")), 5.0);
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvMaxDepth, EveryBehavior, BHV_MaxDepth);

}  // namespace
}  // namespace limpet
