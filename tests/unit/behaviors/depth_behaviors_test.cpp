// SPDX-License-Identifier: MIT
// Behaviors that are about depth: how deep at most, level by level, and up from time to time.
#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string BlockOfDepth(const std::string& type, const std::string& lines) {
  return "Behavior = " + type + "\n{\n  name = " + type + "\n" + lines + "}\n";
}
const std::string kDive = BlockOfDepth("BHV_ConstantDepth", "  depth = 20\n  basewidth = 30\n");

TEST(BhvMaxDepth, HoldsTheVehicleAboveItsDepthAndMindsNoOtherDepth) {
  HelmFlight flight(kDive + BlockOfDepth("BHV_MaxDepth",
                                         "  max_depth = 8\n  tolerance = 1\n  pwt = 200\n"
                                         "  depth_slack_var = SLACK\n"));
  flight.Fly(60.0);
  EXPECT_NEAR(flight.depth(), 8.0, 1e-6);
  EXPECT_NEAR(std::stod(flight.Last("SLACK")), 0.0, 1e-6);
  HelmFlight shallow(BlockOfDepth("BHV_ConstantDepth", "  depth = 3\n") +
                     BlockOfDepth("BHV_MaxDepth", "  max_depth = 8\n  pwt = 200\n"));
  shallow.Fly(30.0);
  EXPECT_NEAR(shallow.depth(), 3.0, 1e-6);
}

TEST(BhvMinAltitudeX, LeavesItsHeightAboveTheSeabed) {
  for (const bool is_stock : {true, false}) {
    HelmFlight flight(kDive +
                      BlockOfDepth("BHV_MinAltitudeX", "  min_altitude = 4\n  pwt = 200\n"));
    for (int i = 0; i < 600; ++i) {
      const double altitude = 15.0 - flight.depth();
      if (is_stock) {
        flight.Say("NAV_ALTITUDE", altitude);
      } else {
        flight.state().nav.altitude = altitude;
      }
      flight.Tick();
    }
    EXPECT_NEAR(flight.depth(), 11.0, 0.1);
    EXPECT_EQ(flight.Last("MIN_ALT_STATUS"), "11");
  }
}

TEST(BhvMinAltitudeX, StopsTheVehicleWhileNobodySaysHowHighItIs) {
  HelmFlight flight(kDive + BlockOfDepth("BHV_MinAltitudeX", "  min_altitude = 4\n"));
  flight.Tick();
  EXPECT_EQ(flight.Last("BHV_ERROR"),
            "BHV_MinAltitudeX: nobody says how high it is above the seabed");
  EXPECT_EQ(flight.Last("MIN_ALT_STATUS"), "Missing NAV_ALTITUDE info");
  EXPECT_TRUE(std::ranges::any_of(flight.decision().turns, &BehaviorTurn::IsEmergency));
  HelmFlight other(kDive +
                   BlockOfDepth("BHV_MinAltitudeX", "  missing_altitude_critical = false\n"));
  other.Tick();
  EXPECT_THAT(other.Posts("BHV_ERROR"), IsEmpty());
}

TEST(BhvGoToDepth, GoesFromLevelToLevelAndStaysAtEach) {
  HelmFlight flight(BlockOfDepth("BHV_GoToDepth",
                                 "  depth = 6,20 : 3,10 : 9\n  capture_delta = 0.2\n"
                                 "  arrival_flag = LEVELS\n  endflag = DONE = true\n"));
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("GTD_LEVELS").empty(); }, 60.0));
  EXPECT_NEAR(flight.depth(), 6.0, 0.25);
  const double arrived = flight.time();
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Posts("GTD_LEVELS").size() == 2; }, 60.0));
  EXPECT_NEAR(flight.time() - arrived, 20.0 + 2.8 / 0.3, 1.0);
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 90.0));
  EXPECT_THAT(flight.Posts("GTD_LEVELS"), ElementsAre("1", "2", "3"));
  EXPECT_THAT(flight.Posts("LEVEL_DEPTH"), ElementsAre("3", "9"));
}

TEST(BhvGoToDepth, RepeatsItsLevels) {
  HelmFlight flight(BlockOfDepth("BHV_GoToDepth",
                                 "  depth = 3 : 1\n  repeat = 1\n  capture_delta = 0.1\n"
                                 "  capture_flag = N\n  endflag = DONE = true\n"));
  flight.Fly(120.0);
  EXPECT_THAT(flight.Posts("GTD_N"), ElementsAre("1", "2", "3", "4"));
  EXPECT_THAT(flight.Posts("DONE"), SizeIs(1));
}

const std::string kSurface =
    "  period = 100\n  pwt = 500\n  zero_speed_depth = 0.5\n  max_time_at_surface = 40\n"
    "  mark_variable = FIX\n";
const std::string kCruise = BlockOfDepth("BHV_ConstantSpeed", "  speed = 1\n");

TEST(BhvPeriodicSurface, ComesUpEachPeriodAndDivesAgainAfterAFix) {
  HelmFlight flight(kDive + kCruise + BlockOfDepth("BHV_PeriodicSurface", kSurface));
  flight.Fly(95.0);
  EXPECT_NEAR(flight.depth(), 20.0, 0.1);
  EXPECT_EQ(flight.Last("PENDING_SURFACE"), "5");
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.depth() <= 0.5; }, 120.0));
  flight.Fly(5.0);
  EXPECT_NEAR(flight.speed(), 0.0, 1e-6) << "it stops at the surface";
  flight.Say("FIX", std::string("43.1,10.2"));
  flight.Fly(0.2);
  EXPECT_EQ(flight.Last("PENDING_SURFACE"), "100");
  flight.Fly(90.0);
  EXPECT_NEAR(flight.depth(), 20.0, 0.1);
  EXPECT_THAT(flight.Posts("PERIODIC_ASCEND"), ElementsAre("true", "false"));
}

TEST(BhvPeriodicSurface, GivesUpWaitingForAFix) {
  HelmFlight flight(kDive + kCruise + BlockOfDepth("BHV_PeriodicSurface", kSurface));
  ASSERT_TRUE(
      flight.FlyUntil([&] { return !flight.Posts("PSF_AT_SURFACE_TIMEOUT").empty(); }, 300.0));
  EXPECT_EQ(flight.Last("TIME_AT_SURFACE"), "40");
  flight.Fly(80.0);
  EXPECT_GT(flight.depth(), 15.0);
}

TEST(BhvPeriodicSurface, SlowsDownOnItsWayUpAsItsGradeSays) {
  const auto speed_at = [](const std::string& grade) {
    HelmFlight flight(kDive + kCruise +
                      BlockOfDepth("BHV_PeriodicSurface", kSurface + "  ascent_grade = " + grade +
                                                              "\n  ascent_speed = 2\n"));
    flight.Fly(110.0);
    flight.FlyUntil([&] { return flight.depth() <= 10.25; }, 120.0);
    return *flight.decision().speed;
  };
  EXPECT_NEAR(speed_at("linear"), 1.0, 0.02);
  EXPECT_NEAR(speed_at("quadratic"), 0.5, 0.02);
  EXPECT_NEAR(speed_at("quasi"), 2.0 * std::pow(0.5, 1.5), 0.02);
  EXPECT_NEAR(speed_at("fullspeed"), 2.0, 0.02);
  EXPECT_NEAR(speed_at("QUADRATIC"), 0.5, 0.02);
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
  const std::string deep = BlockOfDepth("BHV_ConstantDepth", "  depth = 30\n");
  const auto above_seabed = [](const std::string& weight) {
    return BlockOfDepth("BHV_MinAltitudeX", "  min_altitude = 2.4\n  pwt = " + weight + "\n");
  };
  EXPECT_EQ(DepthAtPoints(deep + above_seabed("1000")), 20.0);
  EXPECT_EQ(DepthAtPoints(deep + above_seabed("100")), 20.0) << "of one weight, too";
  const auto at_most = [](const std::string& lines) {
    return BlockOfDepth("BHV_MaxDepth", "  pwt = 200\n  tolerance = 1\n" + lines);
  };
  EXPECT_EQ(DepthAtPoints(deep + at_most("  max_depth = 7.6\n")), 5.0);
  EXPECT_EQ(DepthAtPoints(deep + at_most("  max_depth = 8\n")), 5.0);
}

TEST(BhvConstantDepth, PrefersDepthsAsStockHelmsDo) {
  HelmFlight flight(BlockOfDepth("BHV_ConstantDepth", "  depth = 30\n") +
                    BlockOfDepth("BHV_MaxDepth", "  max_depth = 20\n  basewidth = 0\n"));
  flight.Tick();
  EXPECT_NEAR(flight.decision().depth.value_or(-1.0), 20.0, 0.01) << "of one weight with a limit";
}

}  // namespace
}  // namespace limpet
