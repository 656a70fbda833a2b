// SPDX-License-Identifier: MIT
#include "behaviors/BHV_LegRun.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::string RunBlock(const std::string& lines) {
  return "Behavior = BHV_LegRun\n{\n  name = legs\n  condition = GO = true\n  speed = 2\n"
         "  updates = LEG_UPDATE\n  capture_radius = 4\n  slip_radius = 12\n  lead = 8\n" +
         lines + "}\n";
}

/// A leg of 100 m along the x axis, its first end to the west.
constexpr const char* kEastLeg = "  p1 = 0,0\n  p2 = 100,0\n  turn_rad = 12\n";

HelmFlight UnderWay(const std::string& lines) {
  HelmFlight flight(RunBlock(lines));
  flight.PlaceAt(50.0, 30.0, 270.0);
  flight.Say("GO", std::string("true"));
  return flight;
}

TEST(BhvLegRun, TravelsToAndFroWithATurnBeyondEachEnd) {
  HelmFlight flight =
      UnderWay(std::string(kEastLeg) +
               "  repeat = forever\n  leg_endflag = LEG = $[LEG_ID]\n"
               "  turn_endflag = TURNED = $[MODE]\n  cycleflag = ROUND = $[CYCLES]\n");
  double west = 0.0, east = 0.0, off = 0.0;
  ASSERT_TRUE(flight.FlyUntil(
      [&] {
        west = std::min(west, flight.x());
        east = std::max(east, flight.x());
        const bool is_on_leg =
            flight.Posts("TURNED").size() > 1 && flight.x() > 30.0 && flight.x() < 70.0;
        if (is_on_leg) off = std::max(off, std::abs(flight.y()));
        return flight.Posts("ROUND").size() == 2;
      },
      400.0));
  EXPECT_THAT(flight.Posts("LR_MODE"),
              ElementsAre("leg1", "turn1", "leg2", "turn2", "leg1", "turn1", "leg2", "turn2"));
  EXPECT_THAT(flight.Posts("LEG"), ElementsAre("0", "1", "2", "3"));
  EXPECT_THAT(flight.Posts("ROUND"), ElementsAre("1", "2"));
  EXPECT_THAT(flight.Posts("TURNED"), ElementsAre("turn1", "turn2", "turn1"));
  const double reach = 12.0 * (1.0 + std::sqrt(3.0));  // of a turn beyond its end
  EXPECT_NEAR(west, -reach, 3.0);
  EXPECT_NEAR(east, 100.0 + reach, 3.0);
  EXPECT_LT(off, 2.0) << "back on the leg after a turn";
  EXPECT_THAT(flight.Last("LR_MODE_REPORT"), StartsWith("vname=alpha,mode=turn2,utc=1"));
}

TEST(BhvLegRun, CompletesAfterItsRoundsAndGoesOn) {
  HelmFlight flight = UnderWay(std::string(kEastLeg) + "  endflag = DONE = $[CTR1]\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Posts("DONE").size() == 2; }, 500.0));
  EXPECT_THAT(flight.Posts("LR_MODE"),
              ElementsAre("leg1", "turn1", "leg2", "turn2", "leg1", "turn1", "leg2", "turn2"));
}

TEST(BhvLegRun, GoesFirstToTheEndThatItIsToldTo) {
  for (const auto& [mode, first] : {std::pair{"fixed", "leg1"}, std::pair{"close_turn", "leg2"},
                                    std::pair{"far_turn", "leg1"}}) {
    HelmFlight flight =
        UnderWay(std::string(kEastLeg) + "  init_leg_mode = " + std::string(mode) + "\n");
    flight.PlaceAt(80.0, 0.0, 90.0);
    flight.Tick();
    EXPECT_EQ(flight.Last("LR_MODE"), first) << mode;
    flight.PlaceAt(500.0, 500.0, 90.0);
  }
}

TEST(BhvLegRun, TakesASpeedOfTheListForEachLegFromTheSecondOn) {
  HelmFlight flight =
      UnderWay(std::string(kEastLeg) +
               "  repeat = forever\n  leg_spds = 1, 2:1.5\n  leg_endflag = LEG = $[LEG_ID]\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Posts("LEG").size() == 5; }, 900.0));
  EXPECT_THAT(flight.Posts("LR_NOW_SPD"), ElementsAre("2", "1", "2", "1.5", "2", "1.5", "2"))
      << "turns at the usual speed";
  HelmFlight other = UnderWay(std::string(kEastLeg) +
                              "  repeat = forever\n  leg_spds = 1, 1.5\n  leg_spds_repeat = true\n"
                              "  leg_spds_onturn = true\n  leg_endflag = LEG = $[LEG_ID]\n");
  ASSERT_TRUE(other.FlyUntil([&] { return other.Posts("LEG").size() == 5; }, 900.0));
  EXPECT_THAT(other.Posts("LR_NOW_SPD"), ElementsAre("2", "1", "1.5", "1", "1.5"));
}

TEST(BhvLegRun, SaysWhenItIsSoFarOnALegOrInATurn) {
  HelmFlight flight = UnderWay(std::string(kEastLeg) +
                               "  mid_pct = 40\n  midlegflag = MID = $[PCT_NP]\n"
                               "  mid_turn_pct = 50\n  midturnflag = MIDTURN = $[MODE]\n");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Last("MID").empty(); }, 300.0));
  EXPECT_NEAR(std::stod(flight.Last("MID")), 0.40, 0.01) << "a share, as MOOS-IvP has it";
  EXPECT_NEAR(flight.x(), 40.0, 1.5);
  EXPECT_THAT(flight.Posts("MIDTURN"), ElementsAre("turn1")) << "none on the first leg";
}

TEST(BhvLegRun, IsMovedTurnedAndLengthenedByUpdates) {
  HelmFlight flight = UnderWay("  leg = 0:0:90:100\n  turn_rad = 12\n");
  const auto ends = [&flight](const std::string& update) {
    flight.Say("LEG_UPDATE", update);
    flight.Tick();
    std::string last1, last2;
    for (const std::string& text : flight.Posts("VIEW_POINT")) {
      if (text.find("alpha_p1") != std::string::npos) last1 = text;
      if (text.find("alpha_p2") != std::string::npos) last2 = text;
    }
    return last1 + " " + last2;
  };
  EXPECT_THAT(ends("pwt = 90"), HasSubstr("x=-50"));
  EXPECT_THAT(ends("leg_len_mod = 20"), HasSubstr("x=60"));
  EXPECT_THAT(ends("leg_length_mod = 20"), HasSubstr("x=70")) << "on what there is, by any name";
  EXPECT_THAT(ends("shift_pt = 10,5"), HasSubstr("x=80,y=5"));
  EXPECT_THAT(ends("leg_ang = 0"), HasSubstr("x=10,y=75"));
  EXPECT_THAT(ends("leg_ang_mod = -90"), HasSubstr("x=-60,y=5")) << "west now";
  EXPECT_THAT(ends("p1 = 1,2 # p2 = 3,40"), HasSubstr("x=3,y=40"));
  EXPECT_THAT(flight.Posts("BHV_WARNING"), IsEmpty());
}

TEST(BhvLegRun, GoesOnToTheNextLegWhenItWasIdleInATurn) {
  HelmFlight flight = UnderWay(kEastLeg);
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Last("LR_MODE") == "turn1"; }, 100.0));
  flight.Say("GO", std::string("false"));
  flight.Fly(3.0);
  EXPECT_THAT(flight.Last("VIEW_SEGLIST"), HasSubstr("active=false"));
  flight.Say("GO", std::string("true"));
  flight.Tick();
  EXPECT_EQ(flight.Last("LR_MODE"), "leg2");
}

TEST(BhvLegRun, SaysThatItHasNoLegUntilAnUpdateBringsOne) {
  HelmFlight flight = UnderWay("  turn_rad = 12\n");
  flight.Tick();
  EXPECT_THAT(flight.Last("BHV_WARNING"), HasSubstr("legs: its leg is not set"));
  EXPECT_FALSE(flight.decision().course);
  flight.Say("LEG_UPDATE", std::string("leg = x=0,y=0,ang=90,len=80"));
  flight.Tick();
  EXPECT_TRUE(flight.decision().course);
}

TEST(BhvLegRun, RefusesWhatIsNoLegAndNoTurn) {
  for (const char* line :
       {"leg = 0:0:90", "leg = 0:0:90:0", "leg = x=0,y=0,ang=90,wide=3", "p1 = here",
        "turn1_rad = 0", "turn2_bias = 120", "turn_dir = up", "leg_spds = 0:1", "leg_spds = fast",
        "init_leg_mode = somewhere", "repeat = -1", "turn_pt_gap = 0"}) {
    try {
      HelmFlight flight(RunBlock("  " + std::string(line) + "\n"));
      ADD_FAILURE() << line;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("flight.bhv:10: ")) << line;
    }
  }
}

TEST(BhvLegRun, CountsHowOftenItHasCrossedItsTrackSinceTheLastTurn) {
  HelmFlight flight = UnderWay(std::string(kEastLeg) +
                               "  repeat = forever\n  runxflag = WRAPS = $[WRAPS]\n"
                               "  turn_endflag = TURNED = $[WRAPS]\n");
  // Somebody leads it round by hand.
  for (const auto& [x, y] : {std::pair{60, 0}, {50, 0}, {40, 0}, {30, 10}, {45, 10}, {45, -10}}) {
    flight.PlaceAt(x, y, 270.0);
    flight.Tick();
  }
  EXPECT_EQ(flight.Last("WRAPS"), "1");
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("TURNED").empty(); }, 300.0));
  flight.Tick();
  EXPECT_EQ(flight.Last("WRAPS"), "0") << "anew after a turn";
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvLegRun, EveryBehavior, BHV_LegRun);

}  // namespace
}  // namespace limpet
