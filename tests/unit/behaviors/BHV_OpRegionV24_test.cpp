// SPDX-License-Identifier: MIT
#include "behaviors/BHV_OpRegionV24.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Goes east at 2 m/s for ever; the region is to keep it.
constexpr const char* kEastward =
    "Behavior = BHV_ConstantHeading\n{\n  name = east\n  pwt = 50\n  heading = 90\n}\n"
    "Behavior = BHV_ConstantSpeed\n{\n  name = fast\n  pwt = 50\n  speed = 2\n}\n";

std::string RegionBlock(const std::string& lines) {
  return std::string(kEastward) +
         "Behavior = BHV_OpRegionV24\n{\n  name = region\n  pwt = 300\n  updates = "
         "REGION_UPDATE\n" +
         lines + "}\n";
}

/// A square of 100 m about the origin.
constexpr const char* kCore = "  core_poly = -50,-50 : -50,50 : 50,50 : 50,-50\n";

HelmFlight AtTheOrigin(const std::string& lines) {
  HelmFlight flight(RegionBlock(lines));
  flight.PlaceAt(0.0, 0.0, 90.0);
  return flight;
}

bool IsHalted(const HelmFlight& flight) {
  for (const BehaviorTurn& turn : flight.decision().turns) {
    if (turn.IsEmergency()) return true;
  }
  return false;
}

TEST(BhvOpRegionV24, SteersBackWhoLeavesTheSavePolygon) {
  HelmFlight flight = AtTheOrigin(std::string(kCore) +
                                  "  save_dist = 10\n  save_flag = SAVED = $[CTR1]\n"
                                  "  savex_flag = OUTSIDE = $[CTR]\n  recover_speed = 1.5\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Last("SAVED").empty(); }, 60.0));
  EXPECT_NEAR(flight.x(), 60.0, 0.5) << "10 m about the core";
  EXPECT_NEAR(*flight.decision().course, -1.5708, 0.01) << "straight back";
  EXPECT_EQ(*flight.decision().speed, 1.5);
  double farthest = 0.0;
  for (int i = 0; i < 2000; ++i) {
    flight.Tick();
    farthest = std::max(farthest, flight.x());
  }
  EXPECT_LT(farthest, 75.0);
  EXPECT_GT(flight.Posts("SAVED").size(), 1U) << "once per time that it leaves";
  EXPECT_GT(flight.Posts("OUTSIDE").size(), 5 * flight.Posts("SAVED").size());
  EXPECT_FALSE(IsHalted(flight));
}

TEST(BhvOpRegionV24, StopsWhoLeavesTheHaltPolygonForLongEnough) {
  HelmFlight flight = AtTheOrigin(
      "  halt_poly = -50,-50 : -50,50 : 50,50 : 50,-50\n  trigger_exit_time = 2\n"
      "  breached_poly_flag = BREACHED = $[SECS_OUT_HALT_POLY]\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.x() > 50.0; }, 60.0));
  const double left = flight.time();
  ASSERT_TRUE(flight.FlyUntil([&] { return IsHalted(flight); }, 10.0));
  EXPECT_NEAR(flight.time() - left, 2.0, 0.3);
  flight.Fly(1.0);
  ASSERT_THAT(flight.Posts("BREACHED"), SizeIs(1)) << "told once";
  EXPECT_NEAR(std::stod(flight.Last("BREACHED")), 2.0, 0.11);
  EXPECT_THAT(flight.Last("BHV_ERROR"), HasSubstr("region: it has left halt_poly"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_FALSE(IsHalted(flight)) << "once it is inside again";
}

TEST(BhvOpRegionV24, CountsTheHaltPolygonOnlyOnceItHasBeenEnteredUnlessToldOtherwise) {
  const std::string halt =
      "  halt_poly = 100,-50 : 100,50 : 200,50 : 200,-50\n  trigger_entry_time = 3\n";
  HelmFlight flight = AtTheOrigin(halt);
  flight.Fly(20.0);
  EXPECT_FALSE(IsHalted(flight)) << "it begins outside";
  flight.PlaceAt(199.0, 0.0, 90.0);
  flight.Fly(2.0);
  flight.PlaceAt(210.0, 0.0, 90.0);
  flight.Fly(3.0);
  EXPECT_FALSE(IsHalted(flight)) << "it was inside for less than trigger_entry_time";
  flight.PlaceAt(150.0, 0.0, 90.0);
  flight.Fly(4.0);
  flight.PlaceAt(210.0, 0.0, 90.0);
  flight.Fly(1.0);
  EXPECT_TRUE(IsHalted(flight));
  HelmFlight strict = AtTheOrigin(halt + "  trigger_on_poly_entry = false\n");
  strict.Fly(1.0);
  EXPECT_TRUE(IsHalted(strict));
}

TEST(BhvOpRegionV24, StopsWhoIsTooDeepTooLowOrTooLongUnderWay) {
  HelmFlight flight = AtTheOrigin(
      "  max_depth = 20\n  min_altitude = 5\n  max_time = 30\n"
      "  breached_depth_flag = DEEP = $[DEPTH_LEFT]\n"
      "  breached_altitude_flag = LOW = $[ALT_LEFT]\n"
      "  breached_time_flag = LATE = $[TIME_LEFT]\n");
  flight.state().nav.altitude = 10.0;
  flight.Fly(1.0);
  EXPECT_FALSE(IsHalted(flight));
  flight.state().nav.down = 21.0;
  flight.Tick();
  EXPECT_TRUE(IsHalted(flight));
  EXPECT_THAT(flight.Last("BHV_ERROR"), HasSubstr("deeper than max_depth, 20 m"));
  flight.state().nav.down = 0.0;
  flight.state().nav.altitude = 4.9;
  flight.Tick();
  EXPECT_TRUE(IsHalted(flight));
  EXPECT_THAT(flight.Last("BHV_ERROR"), HasSubstr("nearer to the seabed than min_altitude, 5 m"));
  flight.state().nav.altitude.reset();
  flight.Tick();
  EXPECT_TRUE(IsHalted(flight)) << "nobody says how high it is";
  flight.Say("NAV_ALTITUDE", 10.0);
  flight.Tick();
  EXPECT_FALSE(IsHalted(flight));
  flight.Fly(30.0);
  EXPECT_TRUE(IsHalted(flight));
  EXPECT_THAT(flight.Last("BHV_ERROR"), HasSubstr("max_time, 30 s, is over"));
  EXPECT_THAT(flight.Posts("DEEP"), ElementsAre("0"));
  EXPECT_THAT(flight.Posts("LOW"), ElementsAre("0"));
  EXPECT_THAT(flight.Posts("LATE"), ElementsAre("0"));
}

TEST(BhvOpRegionV24, BeginsAnewWhenItIsReset) {
  for (const auto& [variable, value] :
       {std::pair{"REGION_UPDATE", "reset = true"}, std::pair{"REGION_AGAIN", "true"}}) {
    HelmFlight flight = AtTheOrigin("  max_time = 10\n  reset_var = REGION_AGAIN\n");
    flight.Fly(10.5);
    EXPECT_TRUE(IsHalted(flight));
    flight.Say("REGION_AGAIN", std::string("false"));
    flight.Say("REGION_UPDATE", std::string("max_time = 9"));
    flight.Tick();
    EXPECT_TRUE(IsHalted(flight)) << "neither is a reset";
    flight.Say(variable, std::string(value));
    flight.Fly(8.0);
    EXPECT_FALSE(IsHalted(flight)) << variable;
    flight.Fly(2.0);
    EXPECT_TRUE(IsHalted(flight)) << "once per mail";
  }
}

TEST(BhvOpRegionV24, SaysHowFarItsBordersAre) {
  HelmFlight flight =
      AtTheOrigin(std::string(kCore) +
                  "  save_dist = 10\n  halt_dist = 20\n"
                  "  runflag = FAR = $[DIST_TO_CORE] $[DIST_TO_SAVE] $[DIST_TO_HALT]\n"
                  "  runflag = ETA = $[ETA_TO_CORE] $[SAVE_DIST] $[HALT_DIST]\n"
                  "  runflag = CORE = $[CORE_POLY]\n");
  flight.Tick();
  EXPECT_EQ(flight.Last("FAR"), "50 60 70");
  EXPECT_EQ(flight.Last("ETA"), "10 10 20");
  EXPECT_THAT(flight.Last("CORE"), HasSubstr("50,50"));
}

TEST(BhvOpRegionV24, DrawsItsPolygonsAndErasesThem) {
  HelmFlight flight(RegionBlock(std::string(kCore) +
                                "  condition = GUARD = true\n  halt_dist = 20\n"
                                "  visual_hints = halt_edge_color=purple\n"));
  flight.Say("GUARD", std::string("true"));
  flight.Tick();
  const auto drawn = [&flight](const std::string& label) {
    std::string last;
    for (const std::string& text : flight.Posts("VIEW_POLYGON")) {
      if (text.find(label) != std::string::npos) last = text;
    }
    return last;
  };
  EXPECT_THAT(drawn("opreg_core_alpha"), HasSubstr("edge_color=gray30"));
  EXPECT_THAT(drawn("opreg_halt_alpha"), HasSubstr("edge_color=purple"));
  EXPECT_EQ(drawn("opreg_save_alpha"), "");
  flight.Say("GUARD", std::string("false"));
  flight.Tick();
  EXPECT_THAT(drawn("opreg_core_alpha"), HasSubstr("active=false"));
  EXPECT_THAT(drawn("opreg_halt_alpha"), HasSubstr("active=false"));
}

TEST(BhvOpRegionV24, RefusesADistanceAboutNothingAndAPolygonThatIsNotConvex) {
  const auto complaint = [](const std::string& lines) -> std::string {
    try {
      HelmFlight flight(RegionBlock(lines));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint("  save_dist = 10\n"),
              AllOf(HasSubstr("flight.bhv:18: save_dist: "), HasSubstr("core_poly")));
  EXPECT_THAT(complaint("  core_poly = 0,0 : 10,0 : 2,2 : 0,10\n"), HasSubstr("convex"));
  EXPECT_THAT(complaint("  max_depth = -1\n"), HasSubstr("max_depth"));
  EXPECT_THAT(complaint("  halt_dst = 10\n"), HasSubstr("`halt_dist`"));
}

TEST(BhvOpRegionV24, TakesAnotherCoreFromTheVariableThatTellsIt) {
  HelmFlight flight = AtTheOrigin(std::string(kCore) +
                                  "  save_dist = 10\n  dynamic_region_var = CORE\n"
                                  "  save_flag = SAVED = true\n");
  flight.Fly(1.0);
  flight.Say("CORE", "no polygon");
  flight.Tick();
  EXPECT_EQ(flight.decision().warnings.at(0).warning.id.name(), "REGION_REFUSED");
  flight.Say("CORE", "format=radial, x=0, y=0, radius=150, pts=12");
  flight.Tick();
  EXPECT_TRUE(flight.decision().warnings.empty());
  flight.Say("REGION_UPDATE", "recover_speed = 2");  // leaves the core where mail has put it
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Last("SAVED").empty(); }, 200.0));
  EXPECT_GT(flight.x(), 150.0);
}

TEST(BhvOpRegionV24, SaysHowFarItsBordersAreAlongItsHeading) {
  HelmFlight flight = AtTheOrigin(
      std::string(kCore) +
      "  save_dist = 10\n  halt_dist = 20\n  updates = UP\n"
      "  runxflag = FAR = $[TRAJ_DIST_TO_CORE] $[TRAJ_DIST_TO_SAVE] $[TRAJ_DIST_TO_HALT]\n"
      "  runxflag = ETA = $[TRAJ_ETA_TO_CORE] $[TRAJ_ETA_TO_SAVE] $[TRAJ_ETA_TO_HALT]\n");
  flight.PlaceAt(20.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("FAR"), "30 40 50");
  EXPECT_EQ(flight.Last("ETA"), "6 8 10") << "at the fastest that the helm may ask for";
  flight.PlaceAt(55.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("FAR"), "-1 5 15") << "the core lies astern";
  EXPECT_EQ(flight.Last("ETA"), "-1 1 3");
}

TEST(BhvOpRegionV24, TurnsBackByTheWayRoundThatItHasBegun) {
  for (const auto& [heading, word] : {std::pair{60.0, "left"}, std::pair{120.0, "right"}}) {
    HelmFlight flight = AtTheOrigin(std::string(kCore) + "  save_dist = 10\n");
    flight.Tick();
    flight.PlaceAt(75.0, 0.0, heading);
    flight.Tick();
    EXPECT_EQ(flight.Last("COMMITTED"), word);
    // A gust turns the bow past where the other way round is shorter.
    flight.PlaceAt(75.0, 0.0, 180.0 - heading);
    flight.Tick();
    EXPECT_EQ(flight.Last("COMMITTED"), word);
    const double turn = WrapAngle(*flight.decision().course - YawFromMoosHeading(180.0 - heading));
    EXPECT_EQ(turn < 0.0, heading < 90.0) << heading;
    flight.PlaceAt(75.0, 0.0, 270.0);
    flight.Tick();
    EXPECT_EQ(flight.Last("COMMITTED"), "none") << "it heads for the region";
    EXPECT_NEAR(MoosHeadingFromYaw(*flight.decision().course), 270.0, 0.1);
  }
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvOpRegionV24, EveryBehavior, BHV_OpRegionV24);

}  // namespace
}  // namespace limpet
