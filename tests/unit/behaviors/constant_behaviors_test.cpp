// SPDX-License-Identifier: MIT
// Behaviors that want one heading, speed or depth, and the one that only waits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string Block(const std::string& type, const std::string& lines) {
  return "Behavior = " + type + "\n{\n  name = " + type + "\n" + lines + "}\n";
}

TEST(BhvConstantHeading, TurnsTheVehicleToItsHeadingAndSaysHowFarOffItIs) {
  HelmFlight flight(Block("BHV_ConstantHeading",
                          "  heading = 225\n  peakwidth = 0\n  heading_mismatch_var = OFF\n"));
  flight.PlaceAt(0.0, 0.0, 135.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("OFF"), "90");
  flight.Fly(10.0);
  EXPECT_NEAR(flight.heading_deg(), 225.0, 0.1);
}

TEST(BhvConstantHeading, TakesMoreThanAFullTurnForWhatIsLeftOfIt) {
  HelmFlight flight(Block("BHV_ConstantHeading", "  heading = 450\n"));
  flight.PlaceAt(0.0, 0.0, 45.0);
  flight.Fly(10.0);
  EXPECT_NEAR(flight.heading_deg(), 90.0, 0.1);
}

TEST(BhvConstantHeading, CompletesOnceItIsNearEnoughIfAskedTo) {
  HelmFlight flight(Block("BHV_ConstantHeading",
                          "  heading = 90\n  complete_thresh = 5\n  endflag = DONE = $[OSH]\n"));
  flight.PlaceAt(0.0, 0.0, 0.0);
  flight.Fly(20.0);
  ASSERT_THAT(flight.Posts("DONE"), SizeIs(1));
  EXPECT_NEAR(flight.heading_deg(), 90.0, 5.0);
  EXPECT_THAT(flight.host().statuses(), IsEmpty());
}

TEST(BhvConstantHeading, IsAsContentWithHeadingsWithinItsPeak) {
  HelmFlight flight(
      Block("BHV_ConstantHeading", "  heading = 90\n  peakwidth = 10\n  summitdelta = 0\n") +
      "Behavior = BHV_ConstantHeading\n{\n  name = other\n  heading = 200\n"
      "  pwt = 10\n}\n");
  flight.Tick();
  EXPECT_NEAR(MoosHeadingFromYaw(*flight.decision().course), 100.0, 1e-6)
      << "as far as the lighter one likes";
}

TEST(BhvConstantSpeed, OverridesALighterBidOnSpeedForItsDuration) {
  HelmFlight flight("Behavior = BHV_Waypoint\n{\n  points = 0,1000\n  speed = 2\n  pwt = 100\n}\n" +
                    Block("BHV_ConstantSpeed",
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

TEST(BhvConstantDepth, DivesToItsDepthAndSaysHowFarOffItIs) {
  HelmFlight flight(Block("BHV_ConstantDepth", "  depth = 12\n  depth_mismatch_var = OFF\n"));
  flight.Tick();
  EXPECT_EQ(flight.Last("OFF"), "12");
  flight.Fly(45.0);
  EXPECT_NEAR(flight.depth(), 12.0, 1e-6);
}

TEST(ConstantBehaviors, SayHowFarOffTheVehicleIsAlsoWhileTheyAreIdle) {
  for (const auto& [type, key] : {std::pair{"BHV_ConstantDepth", "depth"},
                                  {"BHV_ConstantSpeed", "speed"},
                                  {"BHV_ConstantHeading", "heading"}}) {
    HelmFlight flight(Block(type, std::string("  condition = GO = true\n  ") + key + " = 20\n  " +
                                      key + "_mismatch_var = OFF\n"));
    flight.Tick();
    const std::string before = flight.Last("OFF");
    EXPECT_NE(before, "") << type;
    flight.PlaceAt(0.0, 0.0, 50.0);
    flight.state().nav.down = 9.0;
    flight.state().nav.u = 1.0;
    flight.Tick();
    EXPECT_NE(flight.Last("OFF"), before) << type << ": a mode may hang on it";
  }
}

TEST(BhvTimer, APerpetualOnesNextTimeBeginsAsTheLastOneEnds) {
  HelmFlight flight(
      "Behavior = BHV_Timer\n{\n  name = t\n  condition = GO = true\n  duration = 10\n"
      "  perpetual = true\n  endflag = GO = false\n  endflag = ENDED = $[UTC]\n}\n");
  flight.Say("GO", std::string("true"));
  flight.Fly(10.5);
  ASSERT_THAT(flight.Posts("ENDED"), SizeIs(1));
  flight.Fly(5.0);
  flight.Say("GO", std::string("true"));
  flight.Fly(4.0);
  EXPECT_THAT(flight.Posts("ENDED"), SizeIs(1));
  flight.Fly(2.0);
  EXPECT_THAT(flight.Posts("ENDED"), SizeIs(2)) << "what it was idle counts, unless told otherwise";
}

TEST(BhvConstantDepth, TakesADepthAboveTheSurfaceForTheSurface) {
  HelmFlight flight(Block("BHV_ConstantDepth", "  depth = -3\n  depth_mismatch_var = OFF\n"));
  flight.Tick();
  EXPECT_EQ(flight.Last("OFF"), "0");
}

TEST(BhvConstantDepth, HasNoLimitWithoutADurationAndSaysThatStockHelmsWouldEndItUnlessToldSo) {
  HelmFlight flight(Block("BHV_ConstantDepth", "  depth = 12\n"));
  flight.Fly(30.0);
  EXPECT_EQ(flight.decision().depth, 12.0);
  EXPECT_THAT(flight.Posts("BHV_WARNING"), SizeIs(1));
  EXPECT_THAT(flight.Last("BHV_WARNING"), ::testing::HasSubstr("BHV_ConstantDepth: duration"));
  EXPECT_THAT(flight.host().IgnoredLines(), SizeIs(1)) << "a note of limpet check";
  for (const char* lines :
       {"  depth = 12\n  duration = no-time-limit\n", "  depth = 12\n  duration = 100\n"}) {
    HelmFlight silent(Block("BHV_ConstantDepth", lines));
    silent.Fly(1.0);
    EXPECT_THAT(silent.Posts("BHV_WARNING"), IsEmpty());
    EXPECT_THAT(silent.host().IgnoredLines(), IsEmpty());
  }
}

TEST(BhvTimer, CountsHowLongItHasRunAndBeenIdleAndBidsOnNothing) {
  HelmFlight flight(Block("BHV_Timer",
                          "  condition = GO = true\n  duration = 5\n  status_suffix = a\n"
                          "  endflag = RING = true\n"));
  flight.Fly(3.05);
  EXPECT_NEAR(std::stod(flight.Last("TIMER_IDLE_a")), 3.0, 0.15);
  flight.Say("GO", std::string("true"));
  flight.Fly(4.0);
  EXPECT_THAT(flight.decision().active, IsEmpty());
  EXPECT_NEAR(std::stod(flight.Last("TIMER_RUNNING_a")), 4.0, 0.25);
  EXPECT_THAT(flight.Posts("RING"), IsEmpty());
  flight.Fly(2.0);
  EXPECT_THAT(flight.Posts("RING"), ElementsAre("true"));
}

TEST(BhvTimer, BeginsAnewWhenItsDurationIsWoundUp) {
  HelmFlight flight(Block("BHV_Timer", "  duration = 5\n  duration_reset = AGAIN\n"));
  flight.Fly(4.0);
  flight.Say("AGAIN", 1.0);
  flight.Fly(4.0);
  EXPECT_LT(std::stod(flight.Last("TIMER_RUNNING")), 4.2);
  EXPECT_THAT(flight.host().statuses(), SizeIs(1));
}

TEST(BhvConstantHeading, FallsWithinItsPeakByItsSummitDelta) {
  HelmFlight flight(Block("BHV_ConstantHeading", "  heading = 90\n  peakwidth = 10\n") +
                    "Behavior = BHV_ConstantHeading\n{\n  name = other\n  heading = 200\n"
                    "  peakwidth = 0\n  pwt = 10\n}\n");
  flight.Tick();
  EXPECT_NEAR(MoosHeadingFromYaw(*flight.decision().course), 90.0, 1e-6);
}

TEST(ClippedValues, AreWarnedOf) {
  HelmFlight flight(Block("BHV_MaxDepth", "  max_depth = -3\n"));
  std::vector<std::string> ids;
  for (const auto& said : flight.host().warnings())
    ids.push_back(said.warning.id.name());
  EXPECT_THAT(ids, ElementsAre(::testing::StartsWith("BHV_VALUES_")));
}

TEST(ClippedValues, AreTakenAsStockHelmsTakeThemAndSaid) {
  const std::string blocks =
      Block("BHV_ConstantSpeed", "  speed = -1\n  peakwidth = -1\n  duration = no-time-limit\n") +
      Block("BHV_ConstantHeading",
            "  heading = 90\n  basewidth = 200\n  peakwidth = 200\n  complete_thresh = -5\n"
            "  duration = no-time-limit\n") +
      Block("BHV_MaxDepth", "  max_depth = -3\n") +
      Block("BHV_StationKeep", "  station_pt = 0,0\n  swing_time = 90\n  inner_radius = .05\n") +
      Block("BHV_PeriodicSurface", "  period = .5\n") +
      Block("BHV_Waypoint",
            "  points = 0,0:9,9\n  repeat = 2.7\n  currix = 1.5\n  capture_radius = 5 m\n"
            "  lead = -5\n");
  HelmFlight flight(blocks);
  std::vector<std::string> said;
  for (const ConfigProblem& line : flight.host().IgnoredLines()) {
    said.push_back(line.key + " " + line.text);
  }
  using ::testing::StartsWith;
  EXPECT_THAT(said, ElementsAre(StartsWith("speed `-1` is taken as 0; allowed: 0 to 100 mps"),
                                StartsWith("peakwidth `-1` is taken as 0"),
                                StartsWith("complete_thresh `-5` is taken as -1"),
                                StartsWith("max_depth `-3` is taken as 0"),
                                StartsWith("swing_time `90` is taken as 60"),
                                StartsWith("repeat `2.7` is taken as 2"),
                                StartsWith("currix `1.5` is taken as 1"),
                                StartsWith("capture_radius `5 m` is taken as 5"),
                                StartsWith("lead `-5` is taken as -1")));
  const std::vector<OwnedWarning> warnings = flight.host().warnings();
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const OwnedWarning& warning) {
    return warning.owner == "BHV_StationKeep" &&
           warning.warning.text == "swing_time: `90` is taken as 60; allowed: 0 to 60 s";
  }));
  EXPECT_THROW(HelmFlight(Block("BHV_ConstantSpeed", "  speed = fast\n")), ConfigError);
}

TEST(CoupledBehaviors, ShareTheirWeightBetweenCourseAndSpeed) {
  const std::string way = Block("BHV_Waypoint", "  points = 0,1000\n  speed = 2\n  pwt = 100\n");
  HelmFlight flight(way + Block("BHV_ConstantSpeed", "  speed = 0.5\n  pwt = 30\n"));
  flight.Tick();
  EXPECT_NEAR(*flight.decision().speed, 0.5, 1e-9)
      << "of the way, which likes that half as well, 50";
  HelmFlight patient(
      Block("BHV_Waypoint", "  points = 0,1000\n  speed = 2\n  pwt = 100\n  patience = 10\n") +
      Block("BHV_ConstantSpeed", "  speed = 0.5\n  pwt = 30\n"));
  patient.Tick();
  EXPECT_NEAR(*patient.decision().speed, 2.0, 1e-9) << "90 of the way";
}

}  // namespace
}  // namespace limpet
