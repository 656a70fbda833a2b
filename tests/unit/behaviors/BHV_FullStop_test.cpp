// SPDX-License-Identifier: MIT
#include "behaviors/BHV_FullStop.hpp"

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

std::string StopBlock(const std::string& lines) {
  return "Behavior = BHV_FullStop\n{\n  name = stop\n  condition = HALT = true\n" + lines + "}\n";
}

/// Under way to the east at 2 m/s when it is told to stop.
void TellToStop(HelmFlight& flight) {
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.state().nav.u = 2.0;
  flight.Say("HALT", std::string("true"));
}

TEST(BhvFullStop, StopsTheVehicleOnItsHeadingAndSaysHowFarItWent) {
  HelmFlight flight(StopBlock("  endflag = STOPPED = $[STOP_DIST]\n"));
  TellToStop(flight);
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Last("STOPPED").empty(); }, 20.0));
  EXPECT_LT(flight.speed(), 0.1);
  EXPECT_NEAR(flight.heading_deg(), 90.0, 1e-6);
  EXPECT_NEAR(std::stod(flight.Last("STOPPED")), flight.x(), 0.1);
  EXPECT_GT(flight.x(), 3.0);
}

TEST(BhvFullStop, StaysStoppedForAsLongAsItsCompletionIsDelayed) {
  HelmFlight flight(StopBlock("  delay_complete = 5\n  endflag = STOPPED = true\n"));
  TellToStop(flight);
  flight.Fly(8.0);
  EXPECT_THAT(flight.Posts("STOPPED"), IsEmpty());
  flight.Fly(2.0);
  EXPECT_THAT(flight.Posts("STOPPED"), ElementsAre("true"));
}

TEST(BhvFullStop, TakesAVehicleThatComesBackForAStoppedOne) {
  HelmFlight flight(StopBlock("  endflag = STOPPED = true\n"));
  TellToStop(flight);
  flight.acceleration = 0.0;
  flight.Fly(1.0);
  flight.PlaceAt(1.5, 0.0, 90.0);
  flight.Tick();
  EXPECT_THAT(flight.Posts("STOPPED"), ElementsAre("true"));
}

TEST(BhvFullStop, MarksForATimeThatItHasBegun) {
  HelmFlight flight(
      StopBlock("  mark_duration = 2\n  mark_flag = BRAKING = true\n"
                "  unmark_flag = BRAKING = false\n  stop_thresh = 0\n"));
  TellToStop(flight);
  flight.Fly(1.9);
  EXPECT_THAT(flight.Posts("BRAKING"), ElementsAre("true"));
  flight.Fly(1.0);
  EXPECT_THAT(flight.Posts("BRAKING"), ElementsAre("true", "false"));
}

TEST(BhvFullStop, DrawsWhereItBeganAndErasesIt) {
  HelmFlight flight(StopBlock("  visual_hints = vertex_color=red\n"));
  TellToStop(flight);
  flight.Tick();
  EXPECT_THAT(flight.Last("VIEW_POINT"), HasSubstr("label=fstop_alpha"));
  EXPECT_THAT(flight.Last("VIEW_POINT"), HasSubstr("vertex_color=red"));
  flight.Say("HALT", std::string("false"));
  flight.Tick();
  EXPECT_THAT(flight.Last("VIEW_POINT"), HasSubstr("active=false"));
}

TEST(BhvFullStop, CompletesOncePerStopIfItLivesOn) {
  HelmFlight flight(StopBlock("  perpetual = true\n  endflag = STOPPED = $[CTR]\n"));
  TellToStop(flight);
  flight.Fly(20.0);
  EXPECT_THAT(flight.Posts("STOPPED"), ElementsAre("1"));
  flight.Say("HALT", std::string("false"));
  flight.Tick();
  TellToStop(flight);
  flight.Fly(20.0);
  EXPECT_THAT(flight.Posts("STOPPED"), ElementsAre("1", "2"));
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvFullStop, EveryBehavior, BHV_FullStop);

}  // namespace
}  // namespace limpet
