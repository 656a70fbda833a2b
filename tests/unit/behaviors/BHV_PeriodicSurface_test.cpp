// SPDX-License-Identifier: MIT
#include "behaviors/BHV_PeriodicSurface.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;

const std::string kSurface =
    "  period = 100\n  pwt = 500\n  zero_speed_depth = 0.5\n  max_time_at_surface = 40\n"
    "  mark_variable = FIX\n";
const std::string kCruise = BehaviorBlock("BHV_ConstantSpeed", "  speed = 1\n");

TEST(BhvPeriodicSurface, ComesUpEachPeriodAndDivesAgainAfterAFix) {
  HelmFlight flight(Dive() + kCruise + BehaviorBlock("BHV_PeriodicSurface", kSurface));
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
  HelmFlight flight(Dive() + kCruise + BehaviorBlock("BHV_PeriodicSurface", kSurface));
  ASSERT_TRUE(
      flight.FlyUntil([&] { return !flight.Posts("PSF_AT_SURFACE_TIMEOUT").empty(); }, 300.0));
  EXPECT_EQ(flight.Last("TIME_AT_SURFACE"), "40");
  flight.Fly(80.0);
  EXPECT_GT(flight.depth(), 15.0);
}

TEST(BhvPeriodicSurface, PutsItsAscentOffByWhatAModemSays) {
  HelmFlight flight(
      Dive() + kCruise +
      BehaviorBlock("BHV_PeriodicSurface", kSurface + "  acomms_mark_variable = MODEM, 30, 50\n"));
  flight.Fly(50.0);
  EXPECT_EQ(flight.Last("PENDING_SURFACE"), "50");
  const auto pending_after = [&flight](const std::string& text) {
    flight.Say("MODEM", text);
    flight.Fly(1.0);
    return std::stod(flight.Last("PENDING_SURFACE"));
  };
  EXPECT_NEAR(pending_after("one"), 79.0, 1.0);
  EXPECT_NEAR(pending_after("one"), 78.0, 1.0) << "the text that it was put off by";
  EXPECT_NEAR(pending_after("two"), 97.0, 1.0) << "50 s in all";
  EXPECT_NEAR(pending_after("three"), 96.0, 1.0);
  flight.Say("FIX", std::string("43.1,10.2"));
  flight.Fly(1.0);
  EXPECT_NEAR(std::stod(flight.Last("PENDING_SURFACE")), 99.0, 1.0) << "a period as any";
  EXPECT_NEAR(pending_after("four"), 128.0, 1.0) << "put off anew";
}

TEST(BhvPeriodicSurface, RefusesAModemsMarkThatIsNone) {
  for (const char* mark : {"A", "A, B", "A, 10", "A B, 10, 20", ", 10, 20", "A, 0, 10", "A, 20, 10",
                           "A, 10, 20, 30", "A, ten, 20"}) {
    EXPECT_THROW(HelmFlight(BehaviorBlock("BHV_PeriodicSurface",
                                          kSurface + "  acomms_mark_variable = " + mark + "\n")),
                 ConfigError)
        << mark;
  }
}

TEST(BhvPeriodicSurface, SlowsDownOnItsWayUpAsItsGradeSays) {
  const auto speed_at = [](const std::string& grade) {
    HelmFlight flight(Dive() + kCruise +
                      BehaviorBlock("BHV_PeriodicSurface", kSurface + "  ascent_grade = " + grade +
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

INSTANTIATE_TYPED_TEST_SUITE_P(BhvPeriodicSurface, EveryBehavior, BHV_PeriodicSurface);

}  // namespace
}  // namespace limpet
