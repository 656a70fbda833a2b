// SPDX-License-Identifier: MIT
#include "behaviors/BHV_AbortToPoint.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string AbortBlock(const std::string& lines) {
  return "Behavior = BHV_AbortToPoint\n{\n  name = abort\n  condition = ABORT = true\n"
         "  speed = 1.5\n  updates = ABORT_UPDATE\n  endflag = ABORTED = $[OSX]\n" +
         lines + "}\n";
}

TEST(BhvAbortToPoint, GoesStraightToItsPointAndHoldsTheVehicleThere) {
  HelmFlight flight(AbortBlock("  point = 100,0\n  radius = 5\n"));
  flight.PlaceAt(0.0, 0.0, 90.0);
  flight.Fly(5.0);
  EXPECT_EQ(flight.x(), 0.0) << "nobody has aborted";
  flight.Say("ABORT", std::string("true"));
  flight.Fly(40.0);
  EXPECT_NEAR(flight.speed(), 1.5, 0.01);
  flight.Fly(200.0);
  EXPECT_LT(std::hypot(flight.x() - 100.0, flight.y()), 5.0);
  EXPECT_LT(flight.speed(), 0.01);
  ASSERT_THAT(flight.Posts("ABORTED"), SizeIs(1)) << "it has arrived once";
  EXPECT_NEAR(std::stod(flight.Last("ABORTED")), 95.0, 0.5);
}

TEST(BhvAbortToPoint, BringsAVehicleBackThatHasDrifted) {
  HelmFlight flight(AbortBlock("  point = 0,0\n  radius = 5\n"));
  flight.Say("ABORT", std::string("true"));
  flight.Tick();
  flight.PlaceAt(0.0, 40.0, 0.0);
  flight.Fly(120.0);
  EXPECT_LT(std::abs(flight.y()), 5.0);
  EXPECT_THAT(flight.Posts("ABORTED"), SizeIs(1));
}

TEST(BhvAbortToPoint, TakesAPointThatItPassesForReachedWithinItsLargerRadius) {
  HelmFlight flight(AbortBlock("  point = 0,0\n  radius = 1\n  nm_radius = 20\n"));
  flight.Say("ABORT", std::string("true"));
  flight.PlaceAt(8.0, 0.0, 0.0);
  flight.Tick();
  flight.PlaceAt(8.0, 9.0, 0.0);
  flight.Tick();
  EXPECT_THAT(flight.Posts("ABORTED"), ElementsAre("8"));
}

TEST(BhvAbortToPoint, GoesToAnotherPointByAnUpdate) {
  HelmFlight flight(AbortBlock("  point = 0,0\n  radius = 5\n"));
  flight.Say("ABORT", std::string("true"));
  flight.Tick();
  flight.Say("ABORT_UPDATE", std::string("point = 0,60"));
  flight.Fly(120.0);
  EXPECT_NEAR(flight.y(), 60.0, 5.0);
  EXPECT_THAT(flight.Posts("ABORTED"), SizeIs(2));
}

TEST(BhvAbortToPoint, IsRefusedWhereNobodyWillEverSayWhereTo) {
  try {
    const HelmFlight flight("Behavior = BHV_AbortToPoint\n{\n  name = abort\n  speed = 1\n}\n");
    FAIL() << "it would stop the vehicle where it is to bring it home";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr(":1: point: is missing in BHV_AbortToPoint, and so is "
                                        "`updates`, which could bring it; allowed: x,y"));
  }
}

TEST(BhvAbortToPoint, StopsTheVehicleWhereNobodyHasSaidYetWhereTo) {
  HelmFlight flight(AbortBlock(""));
  flight.Say("ABORT", std::string("true"));
  flight.Tick();
  EXPECT_THAT(flight.Last("BHV_ERROR"), HasSubstr("abort: it has no point to go to"));
  EXPECT_FALSE(flight.decision().speed);
}

}  // namespace
}  // namespace limpet
