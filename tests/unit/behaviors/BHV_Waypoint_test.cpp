// SPDX-License-Identifier: MIT
#include "behaviors/BHV_Waypoint.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kAlphaRound = 120.0 + 90.0 + 67.082 + 67.082;  // its five points, end to end [m]

std::string Survey(const std::string& lines) {
  return "Behavior = BHV_Waypoint\n{\n  name = survey\n  condition = DEPLOY = true\n"
         "  points = 60,-40 : 60,-160 : 150,-160 : 180,-100 : 150,-40\n  speed = 2\n"
         "  capture_radius = 5\n  slip_radius = 15\n" +
         lines + "}\n";
}

/// Deployed at the first point, heading down the first leg.
HelmFlight AtTheFirstPoint(const std::string& lines) {
  HelmFlight flight(Survey(lines));
  flight.PlaceAt(60.0, -40.0, 180.0);
  flight.state().nav.u = 2.0;
  flight.Say("DEPLOY", std::string("true"));
  return flight;
}

TEST(BhvWaypoint, TravelsTheLapOfTheAlphaMission) {
  HelmFlight flight = AtTheFirstPoint("  lead = 8\n  lead_damper = 1\n  endflag = DONE = true\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 400.0));
  // It ends at the capture radius; turns at 2 m/s and 0.35 rad/s cut corners and swing out.
  EXPECT_NEAR(flight.travelled(), kAlphaRound - 5.0, 0.03 * kAlphaRound);
  EXPECT_NEAR(flight.time(), (kAlphaRound - 5.0) / 2.0, 0.03 * kAlphaRound / 2.0);
  EXPECT_NEAR(std::hypot(flight.x() - 150.0, flight.y() + 40.0), 5.0, 0.5);
  EXPECT_TRUE(flight.host().statuses().at(0).is_complete);
}

TEST(BhvWaypoint, SaysHowDirectlyItTravelsItsLegs) {
  HelmFlight flight =
      AtTheFirstPoint("  efficiency_measure = all\n  lead = 8\n  endflag = DONE = true\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 400.0));
  EXPECT_THAT(flight.Posts("WPT_EFF_DIST_LEG"), SizeIs(4)) << "from the first point to the last";
  EXPECT_GT(std::stod(flight.Last("WPT_EFF_DIST_ALL")), 0.9);
  EXPECT_LE(std::stod(flight.Last("WPT_EFF_DIST_ALL")), 1.0);
  EXPECT_NEAR(std::stod(flight.Last("WPT_EFF_TIME_ALL")),
              std::stod(flight.Last("WPT_EFF_DIST_ALL")), 0.03)
      << "it travels as fast as it is told";
  EXPECT_THAT(flight.Last("WPT_EFF_SUMM_ALL"),
              HasSubstr("vname=alpha, bhv_name=survey, linear_dist=33"));
  EXPECT_LT(std::stod(flight.Last("WPT_ODO")), 1.0) << "of the leg that has just begun";
}

TEST(BhvWaypoint, CountsNoLegThatWasInterruptedOrTravelledAtTwoSpeeds) {
  HelmFlight flight = AtTheFirstPoint("  efficiency_measure = all\n  updates = UP\n");
  flight.Fly(20.0);  // on the first leg
  flight.Say("UP", std::string("speed = 1"));
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "2"; }, 200.0));
  EXPECT_THAT(flight.Posts("WPT_EFF_DIST_LEG"), IsEmpty());
  flight.Fly(10.0);
  flight.Say("DEPLOY", std::string("false"));
  flight.Fly(5.0);
  flight.Say("DEPLOY", std::string("true"));
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "3"; }, 200.0));
  EXPECT_THAT(flight.Posts("WPT_EFF_DIST_LEG"), IsEmpty());
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "4"; }, 200.0));
  EXPECT_THAT(flight.Posts("WPT_EFF_DIST_LEG"), SizeIs(1));
}

TEST(BhvWaypoint, WithoutAMeasureSaysItsWayAlone) {
  HelmFlight flight = AtTheFirstPoint("");
  flight.Fly(30.0);
  EXPECT_THAT(flight.Posts("WPT_EFF_DIST_LEG"), IsEmpty());
  EXPECT_NEAR(std::stod(flight.Last("WPT_ODO")), flight.travelled(), 0.5);
}

TEST(BhvWaypoint, KeepsToItsLegsWhereItIsLed) {
  for (const bool leads : {true, false}) {
    HelmFlight flight("Behavior = BHV_Waypoint\n{\n  points = 0,0 : 200,0\n  speed = 2\n" +
                      std::string(leads ? "  lead = 8\n" : "") + "}\n");
    flight.PlaceAt(0.0, 0.0, 0.0);  // across the leg
    flight.Fly(6.0);
    flight.PlaceAt(flight.x(), 15.0, 90.0);  // carried off the leg
    flight.Fly(25.0);
    EXPECT_EQ(std::abs(flight.y()) < 1.0, leads) << "a third of the way on, " << flight.y();
  }
}

TEST(BhvWaypoint, SaysWhereItIsAsMoosDoes) {
  HelmFlight flight = AtTheFirstPoint("");
  flight.Tick();
  EXPECT_EQ(flight.Last("WPT_STAT"),
            "vname=alpha,behavior-name=survey,index=1,hits=1/1,cycles=0,dist=120,eta=60");
  EXPECT_EQ(flight.Last("WPT_INDEX"), "1");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("CYCLE_INDEX").empty(); }, 400.0));
  EXPECT_THAT(flight.Posts("WPT_INDEX"), ElementsAre("1", "2", "3", "4"));
  EXPECT_EQ(flight.Last("WPT_STAT"), "behavior-name=survey,completed");
  EXPECT_EQ(flight.Last("CYCLE_INDEX"), "1");
}

TEST(BhvWaypoint, PostsItsFlagsInTheirOrder) {
  HelmFlight flight = AtTheFirstPoint(
      "  wptflag = PREV = $(PX),$(PY)\n  wptflag = NEXT = $[NX]\n  cycleflag = ROUND = $[CYCLES]\n"
      "  endflag = DONE = $[WPTS_HIT] of $[WPTS]\n  runflag = RUN = true\n");
  flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 400.0);
  EXPECT_THAT(flight.Posts("PREV"),
              ElementsAre("60,-40", "60,-160", "150,-160", "180,-100", "150,-40"));
  EXPECT_THAT(flight.Posts("NEXT"), ElementsAre("60", "150", "180", "150", "60"));
  EXPECT_THAT(flight.Posts("ROUND"), ElementsAre("1"));
  EXPECT_THAT(flight.Posts("DONE"), ElementsAre("5 of 5"));
  EXPECT_THAT(flight.OrderOf({"PREV", "ROUND", "DONE", "RUN"}),
              ElementsAre("PREV", "RUN", "PREV", "PREV", "PREV", "ROUND", "DONE", "PREV"));
}

TEST(BhvWaypoint, RepeatsAsOftenAsItIsToldAndThenCompletes) {
  HelmFlight flight = AtTheFirstPoint("  repeat = 2\n  endflag = DONE = true\n  lead = 8\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 1500.0));
  const double between = std::hypot(90.0, 0.0);  // from the last point to the first
  EXPECT_NEAR(flight.travelled(), 3.0 * kAlphaRound + 2.0 * between, 0.03 * 3.0 * kAlphaRound);
  EXPECT_THAT(flight.Posts("CYCLE_INDEX"), ElementsAre("1", "2", "3"));
  EXPECT_THAT(flight.host().statuses(), SizeIs(1)) << "what repeats lives on";
}

TEST(BhvWaypoint, TakesAWholeNumberOfRepeatsWithADecimalPoint) {
  HelmFlight flight = AtTheFirstPoint("  repeat = 1.0\n  endflag = DONE = true\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 1500.0));
  EXPECT_THAT(flight.Posts("CYCLE_INDEX"), ElementsAre("1", "2"));
  EXPECT_THROW(HelmFlight(Survey("  repeat = often\n")), ConfigError);
}

TEST(BhvWaypoint, RepeatsForEverIfToldSo) {
  HelmFlight flight = AtTheFirstPoint("  repeat = forever\n  endflag = DONE = true\n");
  flight.Fly(1200.0);
  EXPECT_GE(flight.Posts("CYCLE_INDEX").size(), 5U);
  EXPECT_THAT(flight.Posts("DONE"), IsEmpty());
}

TEST(BhvWaypoint, APerpetualOneTravelsItAllAgain) {
  HelmFlight flight = AtTheFirstPoint("  perpetual = true\n  endflag = DONE = true\n");
  flight.Fly(900.0);
  EXPECT_GE(flight.Posts("DONE").size(), 3U);
}

TEST(BhvWaypoint, GoesOnWhereItWasAfterAnIdleSpellUnlessItIsToReset) {
  for (const bool resets : {false, true}) {
    HelmFlight flight = AtTheFirstPoint(resets ? "  reset_on_idle = true\n" : "");
    flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "2"; }, 200.0);
    flight.Say("DEPLOY", std::string("false"));
    flight.Fly(1.0);
    flight.Say("DEPLOY", std::string("true"));
    flight.Tick();
    EXPECT_EQ(flight.Last("WPT_INDEX"), resets ? "0" : "2");
  }
}

TEST(BhvWaypoint, AnUpdateOfItsSpeedLeavesItsWayAlone) {
  HelmFlight flight = AtTheFirstPoint("  updates = UP\n");
  flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "2"; }, 200.0);
  flight.Say("UP", std::string("speed = 3 # capture_radius = 8"));
  flight.Fly(4.0);
  EXPECT_NEAR(flight.speed(), 3.0, 0.01);
  EXPECT_EQ(flight.Last("WPT_INDEX"), "2");
  EXPECT_THAT(flight.Last("WPT_STAT"), HasSubstr("index=2,hits=2/2"));
}

TEST(BhvWaypoint, AnUpdateOfItsPointsChangesItsWayInFlight) {
  HelmFlight flight = AtTheFirstPoint("  updates = UP\n  endflag = DONE = true\n");
  flight.Fly(20.0);
  flight.Say("UP", std::string("points = 0,0 : 0,100"));
  flight.Tick();
  EXPECT_EQ(flight.Last("WPT_INDEX"), "0");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 300.0));
  EXPECT_NEAR(std::hypot(flight.x(), flight.y() - 100.0), 5.0, 0.5);
}

TEST(BhvWaypoint, MovesItsPointsUnderWayAndKeepsCountOfThem) {
  HelmFlight flight = AtTheFirstPoint("  updates = UP\n");
  flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "2"; }, 200.0);
  flight.Say("UP", std::string("xpoints = 0,0 : 0,0 : 300,-160 : 0,0 : 0,0"));
  flight.Fly(20.0);
  EXPECT_EQ(flight.Last("WPT_INDEX"), "2");
  EXPECT_NEAR(flight.heading_deg(), 90.0, 5.0);
  flight.Say("UP", std::string("xpoints = 0,0 : 0,0"));
  flight.Fly(1.0);
  EXPECT_NEAR(flight.heading_deg(), 90.0, 5.0) << "as many points or none";
}

TEST(BhvWaypoint, TakesAnotherOrderAndAnotherNextPointByUpdates) {
  HelmFlight flight = AtTheFirstPoint("  updates = UP\n");
  flight.Fly(5.0);
  flight.Say("UP", std::string("order = toggle"));
  flight.Tick();
  EXPECT_THAT(flight.Last("WPT_STAT"), HasSubstr("index=0"));
  flight.Fly(15.0);
  EXPECT_GT(flight.x(), 70.0) << "on its way to 150,-40";
  flight.Say("UP", std::string("currix = 2"));
  flight.Tick();
  EXPECT_EQ(flight.Last("WPT_INDEX"), "2");
}

TEST(BhvWaypoint, SlipsPastAPointThatItCannotTurnTo) {
  HelmFlight flight(
      "Behavior = BHV_Waypoint\n{\n  points = 0,50 : 0,200\n  speed = 2\n"
      "  capture_radius = 1\n  slip_radius = 10\n}\n");
  flight.turn_rate = 0.0;
  flight.PlaceAt(6.0, 0.0, 0.0);
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "1"; }, 60.0));
  EXPECT_THAT(flight.Last("WPT_STAT"), HasSubstr("hits=0/1"));
}

TEST(BhvWaypoint, TakesALineAcrossTheLegForAPoint) {
  HelmFlight flight(
      "Behavior = BHV_Waypoint\n{\n  points = 0,50 : 0,200\n  speed = 2\n"
      "  capture_line = absolute\n}\n");
  flight.turn_rate = 0.0;
  flight.PlaceAt(30.0, 0.0, 0.0);
  flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "1"; }, 120.0);
  // The line stands across the leg from 30,0 to 0,50.
  EXPECT_NEAR(-30.0 * (flight.x() - 0.0) + 50.0 * (flight.y() - 50.0), 0.0, 60.0);
}

TEST(BhvWaypoint, SlowsDownBeforeTheEndIfToldSo) {
  HelmFlight flight(
      "Behavior = BHV_Waypoint\n{\n  points = 0,100\n  speed = 2\n"
      "  end_spd = slow_dist=40, stop_dist=10\n  capture_radius = 2\n}\n");
  flight.PlaceAt(0.0, 0.0, 0.0);
  flight.FlyUntil([&] { return flight.y() > 75.0; }, 100.0);
  EXPECT_NEAR(*flight.decision().speed, 1.0, 0.02) << "half way between 40 and 10 m";
}

TEST(BhvWaypoint, ComesBackToWhereTheHelmBegan) {
  HelmFlight flight(
      "Behavior = BHV_Waypoint\n{\n  point = start\n  speed = 2\n"
      "  condition = RETURN = true\n  endflag = DONE = true\n}\n");
  flight.PlaceAt(10.0, 20.0, 0.0);
  flight.Tick();
  flight.PlaceAt(100.0, 20.0, 0.0);
  flight.Say("RETURN", std::string("true"));
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 100.0));
  EXPECT_NEAR(std::hypot(flight.x() - 10.0, flight.y() - 20.0), 3.0, 0.5);
}

TEST(BhvWaypoint, WaitsWithoutAnOpinionForPointsThatAnUpdateBrings) {
  HelmFlight flight(
      "Behavior = BHV_Waypoint\n{\n  points = empty\n  speed = 2\n  updates = UP\n}\n");
  flight.Fly(1.0);
  EXPECT_THAT(flight.decision().active, IsEmpty());
  flight.Say("UP", std::string("points = 0,100"));
  flight.Tick();
  EXPECT_THAT(flight.decision().active, SizeIs(1));
}

TEST(BhvWaypoint, VisitsTheNearestFirstOnAGreedyTour) {
  HelmFlight flight(
      "Behavior = BHV_Waypoint\n{\n  points = 0,90 : 0,30 : 0,60\n  speed = 2\n"
      "  greedy_tour = true\n  wptflag = AT = $[PY]\n}\n");
  flight.PlaceAt(0.0, 0.0, 0.0);
  flight.Fly(60.0);
  EXPECT_THAT(flight.Posts("AT"), ElementsAre("30", "60", "90"));
}

TEST(BhvWaypoint, DrawsItsWayAndErasesItInTheEnd) {
  HelmFlight flight = AtTheFirstPoint("  visual_hints = nextpt_color=red, vertex_size=4\n");
  flight.Tick();
  EXPECT_EQ(flight.Last("VIEW_SEGLIST"),
            "pts={60,-40:60,-160:150,-160:180,-100:150,-40},label=alpha_survey,label_color=white,"
            "edge_color=white,vertex_color=dodger_blue,vertex_size=4,edge_size=1");
  EXPECT_THAT(flight.Posts("VIEW_POINT"),
              Contains("x=60,y=-160,label=alpha's nextpt,label_color=aqua,vertex_color=red,"
                       "vertex_size=5"));
  flight.Fly(1.0);
  EXPECT_THAT(flight.Posts("VIEW_SEGLIST"), SizeIs(1)) << "what has not changed is not repeated";
  flight.Say("DEPLOY", std::string("false"));
  flight.Tick();
  EXPECT_THAT(flight.Last("VIEW_SEGLIST"), HasSubstr("active=false"));
}

TEST(BhvWaypoint, NamesItsStatusAsTheBlockSays) {
  HelmFlight flight = AtTheFirstPoint(
      "  wpt_status_var = MY_STAT\n  post_suffix = a\n"
      "  wpt_index_var = silent\n  wpt_dist_to_next = TO_GO\n");
  flight.Tick();
  EXPECT_THAT(flight.Posts("MY_STAT_a"), SizeIs(1));
  EXPECT_THAT(flight.Posts("WPT_STAT"), IsEmpty());
  EXPECT_THAT(flight.Posts("WPT_INDEX_a"), IsEmpty());
  EXPECT_EQ(flight.Last("TO_GO"), "120");
}

TEST(BhvWaypoint, LeadsOnlyWhileItsConditionHolds) {
  HelmFlight flight = AtTheFirstPoint("  lead = 10\n  lead_condition = LEADS = true\n");
  flight.Tick();
  flight.PlaceAt(70.0, -80.0, 180.0);
  flight.Tick();
  const double direct = MoosHeadingFromYaw(*flight.decision().course);
  flight.Say("LEADS", std::string("true"));
  flight.Tick();
  EXPECT_GT(std::abs(MoosHeadingFromYaw(*flight.decision().course) - direct), 20.0);
}

TEST(BhvWaypoint, RefusesWhatIsNoWayAndSaysWhatWouldBe) {
  for (const char* line :
       {"points = 1,2 : 3", "points = nowhere", "repeat = -1", "order = sideways",
        "capture_line = maybe", "end_spd = 3", "speed = fast", "lead = x", "wpt_status_var = A B",
        "visual_hints = red"}) {
    EXPECT_THROW(HelmFlight(Survey(std::string("  ") + line + "\n")), ConfigError) << line;
  }
}

TEST(BhvWaypoint, ComesNearerAtItsSpeedWhereItsBlockAsksForTheRateOfClosure) {
  HelmFlight flight = AtTheFirstPoint("  ipf_type = roc\n  endflag = DONE = true\n");
  flight.Fly(20.0);
  EXPECT_NEAR(flight.speed(), 2.0, 1e-9);
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 400.0));
  EXPECT_NEAR(flight.travelled(), kAlphaRound - 5.0, 0.05 * kAlphaRound);
}

TEST(BhvWaypoint, CountsOnWhenAnUpdateGivesItOtherPoints) {
  HelmFlight flight = AtTheFirstPoint("  updates = UP\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Last("WPT_INDEX") == "2"; }, 200.0));
  EXPECT_THAT(flight.Last("WPT_STAT"), HasSubstr("hits=2/2"));
  const std::string odometer = flight.Last("WPT_ODO");
  flight.Say("UP", std::string("points = 0,-100 : 0,-200"));
  flight.Fly(0.3);
  EXPECT_THAT(flight.Last("WPT_STAT"), HasSubstr("index=0,hits=2/2"));
  EXPECT_GE(std::stod(flight.Last("WPT_ODO")), std::stod(odometer));
}

TEST(BhvWaypoint, JudgesTheTimeOfALegByItsSpeedAlsoWhileAnotherIsInUse) {
  HelmFlight flight = AtTheFirstPoint(
      "  efficiency_measure = all\n  speed_alt = 1\n  use_alt_speed = true\n"
      "  endflag = DONE = true\n");
  flight.state().nav.u = 1.0;
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 800.0));
  EXPECT_NEAR(std::stod(flight.Last("WPT_EFF_TIME_ALL")),
              0.5 * std::stod(flight.Last("WPT_EFF_DIST_ALL")), 0.03);
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvWaypoint, EveryBehavior, BHV_Waypoint);

}  // namespace
}  // namespace limpet
