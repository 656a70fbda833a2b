// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ZigZag.hpp"

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
using ::testing::SizeIs;

std::string ZigBlock(const std::string& lines) {
  return "Behavior = BHV_ZigZag\n{\n  name = zig\n  speed = 1\n  zig_angle = 30\n"
         "  hdg_thresh = 2\n  updates = ZIG_UPDATE\n" +
         lines + "}\n";
}

TEST(BhvZigZag, TurnsToAndFroAboutItsStemAndCompletes) {
  HelmFlight flight(
      ZigBlock("  stem_hdg = 90\n  max_zig_legs = 3\n  zigflag = LEG = $[ZIGS]:$[ZIG_SIDE]\n"
               "  zagflag = PAIR = $[ZAGS]\n  endflag = DONE = $[ZIGS_TOGO]\n"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  double least = 180.0, most = 0.0;
  ASSERT_TRUE(flight.FlyUntil(
      [&] {
        least = std::min(least, flight.heading_deg());
        most = std::max(most, flight.heading_deg());
        return !flight.Last("DONE").empty();
      },
      60.0));
  EXPECT_NEAR(least, 60.0, 2.5);
  EXPECT_NEAR(most, 120.0, 2.5);
  EXPECT_THAT(flight.Posts("LEG"), ElementsAre("1:port", "2:star", "3:port", "4:star"))
      << "the first, from the stem, is half a leg, which MOOS-IvP does not count";
  EXPECT_THAT(flight.Posts("PAIR"), ElementsAre("1", "2"));
  EXPECT_EQ(flight.Last("DONE"), "0");
}

TEST(BhvZigZag, BeginsOnTheSideThatItIsToldAndSaysWhichSideItIsOn) {
  HelmFlight flight(ZigBlock(
      "  stem_hdg = 0\n  zig_first = right\n  portflag = SIDE = port\n"
      "  starflag = SIDE = star\n  portflagx = ENDED = port\n  starflagx = ENDED = star\n"));
  flight.PlaceAt(0.0, 0.0, 0.0);
  flight.Fly(60.0);
  EXPECT_THAT(flight.Posts("SIDE"), ElementsAre("star", "port", "star"));
  EXPECT_THAT(flight.Posts("ENDED"), ElementsAre("star", "port", "star"));
  EXPECT_THAT(flight.host().statuses(), IsEmpty());
}

TEST(BhvZigZag, TakesHeadingAndSpeedFromTheVehicleIfAskedTo) {
  HelmFlight flight(
      ZigBlock("  stem_on_active = true\n  spd_on_active = true\n  max_zig_legs = 0\n"
               "  zagflag = STEM = $[STEM_HDG] $[STEM_SPD]\n  zagflag = PAIRS = $[ZAGS]\n"));
  flight.PlaceAt(0.0, 0.0, 200.0);
  flight.state().nav.u = 1.5;
  flight.Fly(60.0);
  EXPECT_EQ(flight.Last("STEM"), "200 1.5");
  EXPECT_GT(flight.Posts("PAIRS").size(), 5U) << "without end";
  EXPECT_THAT(flight.Posts("STEM"), SizeIs(1)) << "an unchanged value goes out once";
  EXPECT_NEAR(flight.speed(), 1.5, 0.01);
}

TEST(BhvZigZag, EndsWhereItsStemIsLongEnough) {
  HelmFlight flight(
      ZigBlock("  stem_hdg = 90\n  max_zig_legs = 0\n  max_stem_odo = 20\n"
               "  endflag = DONE = $[STEM_ODO]\n"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Last("DONE").empty(); }, 120.0));
  EXPECT_NEAR(flight.x(), 20.0, 0.3);
  EXPECT_NEAR(std::stod(flight.Last("DONE")), 20.0, 0.2);
}

TEST(BhvZigZag, SteersFurtherOffThanItsLegsIfItIsToTurnFiercely) {
  HelmFlight flight(ZigBlock(
      "  stem_hdg = 90\n  fierce_zigging = true\n  zig_angle_fierce = 70\n  max_zig_zags = 1\n"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Tick();
  EXPECT_NEAR(MoosHeadingFromYaw(*flight.decision().course), 20.0, 1e-6);
  flight.Fly(30.0);
  EXPECT_THAT(flight.host().statuses(), IsEmpty()) << "and the turns end all the same";
}

TEST(BhvZigZag, GoesFasterAndSlowerByUpdatesAndBack) {
  HelmFlight flight(ZigBlock("  stem_hdg = 90\n  max_zig_legs = 0\n"));
  flight.Tick();
  flight.Say("ZIG_UPDATE", std::string("mod_speed = 0.5"));
  flight.Tick();
  EXPECT_NEAR(*flight.decision().speed, 1.5, 1e-9);
  flight.Say("ZIG_UPDATE", std::string("mod_speed = 0.25"));
  flight.Tick();
  EXPECT_NEAR(*flight.decision().speed, 1.75, 1e-9);
  flight.Say("ZIG_UPDATE", std::string("mod_speed = reset"));
  flight.Tick();
  EXPECT_NEAR(*flight.decision().speed, 1.0, 1e-9);
}

TEST(BhvZigZag, DrawsItsHeadingsUnlessToldNotTo) {
  HelmFlight flight(
      ZigBlock("  stem_hdg = 90\n  condition = GO = true\n"
               "  visual_hints = draw_req_hdg=false, set_hdg_color=red\n"));
  flight.Say("GO", std::string("true"));
  flight.Tick();
  ASSERT_THAT(flight.Posts("VIEW_SEGLIST"), SizeIs(1));
  EXPECT_THAT(flight.Last("VIEW_SEGLIST"), HasSubstr("label=zig_set_alpha"));
  EXPECT_THAT(flight.Last("VIEW_SEGLIST"), HasSubstr("edge_color=red"));
  flight.Say("GO", std::string("false"));
  flight.Tick();
  EXPECT_THAT(flight.Last("VIEW_SEGLIST"), HasSubstr("active=false"));
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvZigZag, EveryBehavior, BHV_ZigZag);

}  // namespace
}  // namespace limpet
