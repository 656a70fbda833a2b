// SPDX-License-Identifier: MIT
#include "behaviors/BHV_MinAltitudeX.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::IsEmpty;

TEST(BhvMinAltitudeX, LeavesItsHeightAboveTheSeabed) {
  for (const bool is_stock : {true, false}) {
    HelmFlight flight(Dive() +
                      BehaviorBlock("BHV_MinAltitudeX", "  min_altitude = 4\n  pwt = 200\n"));
    for (int i = 0; i < 600; ++i) {
      const double altitude = 15.0 - flight.depth();
      if (is_stock) {
        flight.Say("NAV_ALTITUDE", altitude);
      } else {
        flight.state().nav.altitude = altitude;
      }
      flight.Tick();
    }
    EXPECT_NEAR(flight.depth(), 11.0, 0.1);
    EXPECT_EQ(flight.Last("MIN_ALT_STATUS"), "11");
  }
}

TEST(BhvMinAltitudeX, StopsTheVehicleWhileNobodySaysHowHighItIs) {
  HelmFlight flight(Dive() + BehaviorBlock("BHV_MinAltitudeX", "  min_altitude = 4\n"));
  flight.Tick();
  EXPECT_EQ(flight.Last("BHV_ERROR"),
            "BHV_MinAltitudeX: nobody says how high it is above the seabed");
  EXPECT_EQ(flight.Last("MIN_ALT_STATUS"), "Missing NAV_ALTITUDE info");
  EXPECT_TRUE(std::ranges::any_of(flight.decision().turns, &BehaviorTurn::IsEmergency));
  HelmFlight other(Dive() +
                   BehaviorBlock("BHV_MinAltitudeX", "  missing_altitude_critical = false\n"));
  other.Tick();
  EXPECT_THAT(other.Posts("BHV_ERROR"), IsEmpty());
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvMinAltitudeX, EveryBehavior, BHV_MinAltitudeX);

}  // namespace
}  // namespace limpet
