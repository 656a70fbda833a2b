// SPDX-License-Identifier: MIT
#include "behaviors/BHV_OpRegion.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

const SurveyArea kRegionArea{-10.0, 10.0, -10.0, 10.0, 2.0, 2.0};

VehicleState StateAt(double north, const std::string& purpose = "") {
  VehicleState state;
  state.nav.north = north;
  state.area = kRegionArea;
  if (!purpose.empty()) {
    state.guidance = Guidance{.purpose = purpose};
  }
  return state;
}

TEST(BhvOpRegion, AsksForAWayIn) {
  const BHV_OpRegion behavior({});
  SearchGoals goals;
  behavior.Shape({}, 1.0, goals);
  EXPECT_TRUE(goals.leads_into_region);
}

TEST(BhvOpRegion, VetoesWhatDoesNotLeadAVehicleOutsideIn) {
  const Region region(kRegionArea);
  const BHV_OpRegion behavior({});
  Situation now;
  now.pose = {20.0, 0.0, std::numbers::pi};
  now.region = &region;
  const auto has_veto = [&](double length, const std::string& source) {
    const Option option{.source = source, .path = DubinsPath(now.pose, {{0.0, length}})};
    return behavior.Value(Prospect(option, {}), now)->veto.has_value();
  };
  EXPECT_FALSE(has_veto(20.0, "transit"));
  EXPECT_TRUE(has_veto(3.0, "transit"));
  EXPECT_FALSE(has_veto(3.0, "home"));
}

TEST(BhvOpRegion, VetoesEveryWayThroughAZoneAlsoTheOneHome) {
  SurveyArea area = kRegionArea;
  area.keep_out = "{2,-2:4,-2:4,2:2,2}";  // x 2 to 4, east of the middle
  const Region region(area);
  const BHV_OpRegion behavior({});
  Situation now;
  now.pose = {0.0, -5.0, std::numbers::pi / 2.0};
  now.region = &region;
  const auto veto_of = [&](double length, const std::string& source) {
    const Option option{.source = source, .path = DubinsPath(now.pose, {{0.0, length}})};
    return behavior.Value(Prospect(option, {}), now)->veto.value_or("");
  };
  EXPECT_EQ(veto_of(6.0, "beam"), "");
  EXPECT_EQ(veto_of(8.0, "beam"), "enters a keep-out zone");
  EXPECT_EQ(veto_of(30.0, "home"), "enters a keep-out zone");
}

TEST(BhvOpRegion, VetoesAWayInThroughAZoneUnlessTheVehicleIsInIt) {
  SurveyArea area = kRegionArea;
  area.keep_out = "{-8,13:8,13:8,15:-8,15}";  // y 13 to 15, north of the region
  const Region region(area);
  const BHV_OpRegion behavior({});
  Situation now;
  now.region = &region;
  const auto veto_from = [&](double north) {
    now.pose = {north, 0.0, std::numbers::pi};
    const Option option{.source = "beam", .path = DubinsPath(now.pose, {{0.0, north - 4.0}})};
    return behavior.Value(Prospect(option, {}), now)->veto.value_or("");
  };
  EXPECT_EQ(veto_from(20.0), "enters a keep-out zone");
  EXPECT_EQ(veto_from(14.0), "") << "it must get out, and this is a way out";
  EXPECT_EQ(veto_from(12.0), "") << "the zone is behind it";
}

TEST(BhvOpRegion, VetoesOtherWaysInThanTheMissionsTransit) {
  SurveyArea area = kRegionArea;
  area.transit = "{40,60:0,40}";
  const Region region(area);
  const BHV_OpRegion behavior({});
  Situation now;
  now.region = &region;
  now.pose = {20.0, 0.0, std::numbers::pi};
  const auto veto_of = [&](const std::string& source) {
    const Option option{.source = source, .path = DubinsPath(now.pose, {{0.0, 16.0}})};
    return behavior.Value(Prospect(option, {}), now)->veto.value_or("");
  };
  EXPECT_EQ(veto_of("transit"), "");
  EXPECT_EQ(veto_of("beam"), "is not the mission's transit");
  EXPECT_EQ(veto_of("home"), "");
}

TEST(BhvOpRegion, LeadsAVehicleThatDriftedIntoAZoneBackOut) {
  SurveyArea area = kRegionArea;
  area.keep_out = "{2,-2:4,-2:4,2:2,2}";
  BHV_OpRegion behavior({});
  VehicleState state = StateAt(0.0);
  state.area = area;
  behavior.Start(state);
  static_cast<void>(behavior.Move(state));
  state.nav.east = 3.0;
  const MotionBid bid = behavior.Move(state);
  EXPECT_EQ(bid.warning->id.name(), "OUTSIDE_REGION");
  EXPECT_TRUE(bid.course);
}

TEST(BhvOpRegion, IsInForceOnlyOnceEntered) {
  BHV_OpRegion behavior({});
  behavior.Start(StateAt(60.0));
  EXPECT_FALSE(behavior.Move(StateAt(60.0, "transit")).warning);
  EXPECT_FALSE(behavior.Move(StateAt(5.0, "beam")).warning);
  EXPECT_EQ(behavior.Move(StateAt(13.0, "beam")).warning->id.name(), "OUTSIDE_REGION");
}

TEST(BhvOpRegion, LetsTheWayHomeLeave) {
  BHV_OpRegion behavior({});
  behavior.Start(StateAt(5.0));
  static_cast<void>(behavior.Move(StateAt(5.0, "home")));
  EXPECT_FALSE(behavior.Move(StateAt(30.0, "home")).warning);
}

TEST(BhvOpRegion, TurnsAVehicleThatStandsBeforeABorderWithoutAPathOnTheSpotAndLeadsItInside) {
  BHV_OpRegion behavior({});
  VehicleState state = StateAt(10.5);  // heads north
  const auto wish_after = [&](double seconds) {
    state.now += Seconds(seconds);
    return behavior.Move(state);
  };
  behavior.Start(state);
  EXPECT_FALSE(wish_after(0.0).course);
  EXPECT_FALSE(wish_after(1.0).course) << "a decision may take a while";
  const MotionBid turn = wish_after(1.5);
  ASSERT_TRUE(turn.course && turn.speed);
  EXPECT_NEAR(std::abs(turn.course->summit), std::numbers::pi, 1e-9);
  EXPECT_EQ(turn.speed->summit, 0.0);
  state.nav.yaw = std::numbers::pi;
  EXPECT_GT(wish_after(10.0).speed->summit, 0.1);
  state.guidance = Guidance{.purpose = "plan"};
  EXPECT_FALSE(wish_after(1.0).course) << "it has found a path";
  state.guidance.reset();
  EXPECT_FALSE(wish_after(1.0).course);
  state.nav.north = 0.2;
  EXPECT_FALSE(wish_after(10.0).course) << "it is as far inside as can be: that is no trap";
}

TEST(BhvOpRegion, SaysWhereItCannotBeSureToBeInside) {
  BHV_OpRegion behavior({});
  VehicleState state = StateAt(9.0);  // 3 m from the border
  state.nav.sd_north = state.nav.sd_east = 0.9;
  behavior.Start(state);
  EXPECT_FALSE(behavior.Move(state).warning);
  state.nav.sd_east = 1.1;
  ASSERT_TRUE(behavior.Move(state).warning);
  EXPECT_EQ(behavior.Move(state).warning->id.name(), "REGION_IN_DOUBT");
  state.nav.sd_east = 0.9;
  EXPECT_TRUE(behavior.Move(state).warning) << "not before it is surely over";
  state.nav.north = 8.0;
  EXPECT_FALSE(behavior.Move(state).warning);
}

TEST(BhvOpRegion, IsInNoDoubtOnTheWayHome) {
  BHV_OpRegion behavior({});
  VehicleState state = StateAt(9.0, "home");
  state.nav.sd_north = 2.0;
  behavior.Start(state);
  EXPECT_FALSE(behavior.Move(state).warning);
}

TEST(BhvOpRegion, SaysOnTheWayHomeAndOnTheWayInWhereItMayBeInAZone) {
  for (const char* purpose : {"home", "transit"}) {
    BHV_OpRegion behavior({});
    VehicleState state = StateAt(14.0, purpose);  // outside
    state.area->keep_out = "{-1,16:1,16:1,18:-1,18}";
    state.nav.sd_north = 0.5;
    behavior.Start(state);
    EXPECT_FALSE(behavior.Move(state).warning) << purpose;
    state.nav.north = 15.0;
    ASSERT_TRUE(behavior.Move(state).warning) << purpose;
    EXPECT_EQ(behavior.Move(state).warning->id.name(), "REGION_IN_DOUBT");
    state.nav.north = 17.0;
    ASSERT_TRUE(behavior.Move(state).warning);
    EXPECT_EQ(behavior.Move(state).warning->id.name(), "OUTSIDE_REGION");
  }
}

/// Goes east at 2 m/s for ever, from the origin.
HelmFlight Eastward(const std::string& lines) {
  HelmFlight flight(
      "Behavior = BHV_ConstantHeading\n{\n  name = east\n  pwt = 50\n  heading = 90\n}\n"
      "Behavior = BHV_ConstantSpeed\n{\n  name = fast\n  pwt = 50\n  speed = 2\n}\n"
      "Behavior = BHV_OpRegion\n{\n  name = region\n  pwt = 300\n  polygon = "
      "-50,-50 : -50,50 : 50,50 : 50,-50\n" +
      lines + "}\n");
  flight.PlaceAt(0.0, 0.0, 90.0);
  return flight;
}

TEST(BhvOpRegion, StopsWhoLeavesAPolygonOrALimitAsMissionsOfMoosIvpSay) {
  HelmFlight flight = Eastward("  trigger_exit_time = 2\n  breached_poly_flag = OUT = true\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Last("BHV_ERROR").empty(); }, 60.0));
  EXPECT_GT(flight.x(), 50.0);
  EXPECT_EQ(flight.Last("BHV_ERROR"), "region: it has left polygon");
  EXPECT_EQ(flight.Posts("OUT").size(), 1U);
  HelmFlight timed = Eastward("  max_time = 15\n  time_remaining_var = LEFT\n");
  timed.Fly(1.0);
  EXPECT_EQ(timed.Last("LEFT"), "14");
  ASSERT_TRUE(timed.FlyUntil([&] { return !timed.Last("BHV_ERROR").empty(); }, 60.0));
  EXPECT_NEAR(timed.time(), 15.0, 0.3);
  EXPECT_EQ(timed.Last("LEFT"), "0");
}

TEST(BhvOpRegion, GivesTheVehicleToTheOperatorWhereTheBreachIsSoft) {
  HelmFlight flight = Eastward(
      "  soft_poly_breach = true\n  breached_poly_flag = OUT = true\n  opregion_poly_var = "
      "REGION\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Last("OUT").empty(); }, 60.0));
  EXPECT_EQ(flight.Last("MOOS_MANUAL_OVERRIDE"), "true");
  EXPECT_EQ(flight.Last("BHV_ERROR"), "");
  EXPECT_EQ(flight.Last("REGION"), "pts={-50,-50:-50,50:50,50:50,-50}");
}

TEST(BhvOpRegion, SaysThatNoBorderIsAheadWhereItHasNoPolygon) {
  HelmFlight flight("Behavior = BHV_OpRegion\n{\n  name = region\n}\n");
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  for (const char* variable : {"OPREG_TRAJECTORY_PERIM_DIST", "OPREG_TRAJECTORY_PERIM_ETA",
                               "OPREG_ABSOLUTE_PERIM_DIST", "OPREG_ABSOLUTE_PERIM_ETA"}) {
    EXPECT_EQ(flight.Last(variable), "-1") << variable;
  }
  EXPECT_EQ(flight.Last("SECS_IN_POLY"), "0");
  HelmFlight survey("Behavior = BHV_OpRegion\n{\n  name = region\n}\n");
  survey.state().area = kRegionArea;
  survey.Tick();
  EXPECT_TRUE(survey.Posts("OPREG_ABSOLUTE_PERIM_DIST").empty()) << "it has a region";
}

TEST(BhvOpRegion, SaysHowFarItsBorderIsAndHowLongItIsInside) {
  HelmFlight flight = Eastward("  max_time = 100\n");
  flight.state().nav.u = 2.0;
  flight.Tick();
  EXPECT_EQ(flight.Last("OPREG_TRAJECTORY_PERIM_DIST"), "50");
  EXPECT_EQ(flight.Last("OPREG_TRAJECTORY_PERIM_ETA"), "25");
  EXPECT_EQ(flight.Last("OPREG_ABSOLUTE_PERIM_DIST"), "50");
  EXPECT_EQ(flight.Last("OPREG_ABSOLUTE_PERIM_ETA"), "10") << "at 5 m/s";
  EXPECT_EQ(flight.Last("OPREG_TIME_REMAINING"), "100");
  EXPECT_EQ(flight.Last("SECS_IN_POLY"), "0");
  flight.Fly(10.0);
  EXPECT_EQ(flight.Last("OPREG_TRAJECTORY_PERIM_DIST"), "30");
  EXPECT_NEAR(std::stod(flight.Last("OPREG_TIME_REMAINING")), 90.0, 0.01);
  EXPECT_NEAR(std::stod(flight.Last("SECS_IN_POLY")), 10.0, 0.01);
  flight.PlaceAt(49.4, 30.0, 0.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("OPREG_TRAJECTORY_PERIM_DIST"), "20");
  EXPECT_NEAR(std::stod(flight.Last("OPREG_ABSOLUTE_PERIM_DIST")), 0.6, 1e-6) << "the last metre";
  flight.PlaceAt(60.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("OPREG_TRAJECTORY_PERIM_DIST"), "-1") << "not that way";
  EXPECT_EQ(flight.Last("SECS_IN_POLY"), "0");
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvOpRegion, EveryBehavior, BHV_OpRegion);

}  // namespace
}  // namespace limpet
