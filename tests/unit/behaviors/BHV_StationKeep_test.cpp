// SPDX-License-Identifier: MIT
#include "behaviors/BHV_StationKeep.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string Keep(const std::string& lines) {
  return "Behavior = BHV_StationKeep\n{\n  name = keep\n  condition = STAY = true\n" + lines +
         "}\n";
}

TEST(BhvStationKeep, GoesToItsStationAndStopsThere) {
  HelmFlight flight(
      Keep("  station_pt = 100,50\n  inner_radius = 4\n  outer_radius = 20\n"
           "  outer_speed = 1\n  transit_speed = 2\n"));
  flight.Say("STAY", std::string("true"));
  flight.PlaceAt(0.0, 50.0, 90.0);
  flight.Tick();
  EXPECT_NEAR(*flight.decision().speed, 2.0, 1e-9);
  flight.PlaceAt(88.0, 50.0, 90.0);
  flight.Tick();
  EXPECT_NEAR(*flight.decision().speed, 0.5, 0.02) << "half way between the radii";
  flight.Fly(120.0);
  EXPECT_LT(std::hypot(flight.x() - 100.0, flight.y() - 50.0), 5.0);
  EXPECT_LT(flight.speed(), 0.1);
  EXPECT_LT(std::stod(flight.Last("DIST_TO_STATION")), 5.0);
}

TEST(BhvStationKeep, StaysInsideItsRadiusInACurrent) {
  HelmFlight flight(Keep("  station_pt = 0,0\n  inner_radius = 3\n  outer_radius = 10\n"));
  flight.Say("STAY", std::string("true"));
  for (int i = 0; i < 3000; ++i) {
    flight.Tick();
    flight.state().nav.east += 0.03;  // 0.3 m/s
    EXPECT_LT(std::hypot(flight.x(), flight.y()), 10.0);
  }
}

TEST(BhvStationKeep, StaysWhereItWasActivatedIfAskedTo) {
  HelmFlight flight(Keep("  center_activate = true\n"));
  flight.PlaceAt(30.0, 40.0, 0.0);
  flight.Say("STAY", std::string("true"));
  flight.Tick();
  flight.PlaceAt(30.0, 70.0, 0.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("DIST_TO_STATION"), "30");
  flight.Say("STAY", std::string("false"));
  flight.Tick();
  flight.Say("STAY", std::string("true"));
  flight.Tick();
  EXPECT_EQ(flight.Last("DIST_TO_STATION"), "0") << "each time anew";
}

TEST(BhvStationKeep, LetsItsStationSwingOutFirst) {
  HelmFlight flight(Keep("  center_activate = true\n  swing_time = 5\n"));
  flight.Say("STAY", std::string("true"));
  flight.state().nav.u = 2.0;
  flight.acceleration = 0.2;
  flight.Fly(4.0);
  EXPECT_EQ(flight.Last("DIST_TO_STATION"), "0");
}

TEST(BhvStationKeep, RestsUntilItHasDriftedFarIfItMayHibernate) {
  HelmFlight flight(Keep("  station_pt = 0,0\n  inner_radius = 4\n  hibernation_radius = 25\n"));
  flight.Say("STAY", std::string("true"));
  flight.PlaceAt(20.0, 0.0, 0.0);
  flight.Fly(20.0);
  EXPECT_EQ(flight.Last("PSKEEP_MODE"), "HIBERNATING");
  EXPECT_NEAR(flight.x(), 20.0, 1e-9);
  flight.PlaceAt(27.0, 0.0, 0.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("PSKEEP_MODE"), "SEEKING_STATION");
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Last("PSKEEP_MODE") == "HIBERNATING"; }, 120.0));
  EXPECT_LT(std::hypot(flight.x(), flight.y()), 5.0);
}

TEST(BhvStationKeep, TakesAnotherStationByAnUpdate) {
  HelmFlight flight(Keep("  station_pt = 0,0\n  updates = UP\n"));
  flight.Say("STAY", std::string("true"));
  flight.Tick();
  flight.Say("UP", std::string("station_pt = 0,60"));
  flight.Tick();
  EXPECT_EQ(flight.Last("DIST_TO_STATION"), "60");
  flight.Say("UP", std::string("inner_radius = 5"));
  flight.Fly(1.0);
  EXPECT_GT(std::stod(flight.Last("DIST_TO_STATION")), 50.0) << "the station stays";
}

TEST(BhvStationKeep, DrawsItsCirclesAndErasesThem) {
  HelmFlight flight(Keep("  station_pt = 0,0\n  hibernation_radius = 40\n"));
  flight.Say("STAY", std::string("true"));
  flight.Tick();
  EXPECT_THAT(flight.Posts("VIEW_POLYGON"), SizeIs(3));
  EXPECT_THAT(flight.Posts("VIEW_POLYGON").at(0), HasSubstr("label=alpha:station-keep-out"));
  flight.Say("STAY", std::string("false"));
  flight.Tick();
  EXPECT_THAT(flight.Last("VIEW_POLYGON"), HasSubstr("active=false"));
}

TEST(BhvStationKeep, WarnsWhileItKnowsNoStation) {
  HelmFlight flight(Keep(""));
  flight.Say("STAY", std::string("true"));
  flight.Tick();
  EXPECT_EQ(flight.decision().warnings.at(0).warning.id.name(), "STATION_POINT_NOT_SET");
}

TEST(BhvStationKeep, StaysHereAtOnceWhenAnUpdateSaysSo) {
  HelmFlight flight(Keep("  station_pt = 0,0\n  updates = KEEP\n"));
  flight.Say("STAY", std::string("true"));
  flight.PlaceAt(30.0, 40.0, 0.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("DIST_TO_STATION"), "50");
  flight.Say("KEEP", std::string("center_activate = true"));
  flight.Tick();
  EXPECT_EQ(flight.Last("DIST_TO_STATION"), "0");
  flight.PlaceAt(30.0, 70.0, 0.0);
  flight.Tick();
  EXPECT_NEAR(std::stod(flight.Last("DIST_TO_STATION")), 30.0, 0.1) << "the station stays";
  flight.Say("KEEP", std::string("center_activate = false"));
  flight.PlaceAt(30.0, 40.0, 0.0);
  flight.Tick();
  EXPECT_NEAR(std::stod(flight.Last("DIST_TO_STATION")), 50.0, 0.1) << "back to its own";
}

TEST(BhvStationKeep, SaysThatItDoesNotHibernate) {
  HelmFlight flight(Keep("  station_pt = 0,0\n"));
  flight.Say("STAY", std::string("true"));
  flight.Tick();
  EXPECT_EQ(flight.Last("PSKEEP_MODE"), "DISABLED");
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvStationKeep, EveryBehavior, BHV_StationKeep);

}  // namespace
}  // namespace limpet
