// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ConstantHeading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(BhvConstantHeading, TurnsTheVehicleToItsHeadingAndSaysHowFarOffItIs) {
  HelmFlight flight(BehaviorBlock(
      "BHV_ConstantHeading", "  heading = 225\n  peakwidth = 0\n  heading_mismatch_var = OFF\n"));
  flight.PlaceAt(0.0, 0.0, 135.0);
  flight.Tick();
  EXPECT_EQ(flight.Last("OFF"), "90");
  flight.Fly(10.0);
  EXPECT_NEAR(flight.heading_deg(), 225.0, 0.1);
}

TEST(BhvConstantHeading, TakesMoreThanAFullTurnForWhatIsLeftOfIt) {
  HelmFlight flight(BehaviorBlock("BHV_ConstantHeading", "  heading = 450\n"));
  flight.PlaceAt(0.0, 0.0, 45.0);
  flight.Fly(10.0);
  EXPECT_NEAR(flight.heading_deg(), 90.0, 0.1);
}

TEST(BhvConstantHeading, CompletesOnceItIsNearEnoughIfAskedTo) {
  HelmFlight flight(BehaviorBlock(
      "BHV_ConstantHeading", "  heading = 90\n  complete_thresh = 5\n  endflag = DONE = $[OSH]\n"));
  flight.PlaceAt(0.0, 0.0, 0.0);
  flight.Fly(20.0);
  ASSERT_THAT(flight.Posts("DONE"), SizeIs(1));
  EXPECT_NEAR(flight.heading_deg(), 90.0, 5.0);
  EXPECT_THAT(flight.host().statuses(), IsEmpty());
}

TEST(BhvConstantHeading, IsAsContentWithHeadingsWithinItsPeak) {
  HelmFlight flight(BehaviorBlock("BHV_ConstantHeading",
                                  "  heading = 90\n  peakwidth = 10\n  summitdelta = 0\n") +
                    "Behavior = BHV_ConstantHeading\n{\n  name = other\n  heading = 200\n"
                    "  pwt = 10\n}\n");
  flight.Tick();
  EXPECT_NEAR(MoosHeadingFromYaw(*flight.decision().course), 100.0, 1e-6)
      << "as far as the lighter one likes";
}

TEST(BhvConstantHeading, FallsWithinItsPeakByItsSummitDelta) {
  HelmFlight flight(BehaviorBlock("BHV_ConstantHeading", "  heading = 90\n  peakwidth = 10\n") +
                    "Behavior = BHV_ConstantHeading\n{\n  name = other\n  heading = 200\n"
                    "  peakwidth = 0\n  pwt = 10\n}\n");
  flight.Tick();
  EXPECT_NEAR(MoosHeadingFromYaw(*flight.decision().course), 90.0, 1e-6);
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvConstantHeading, EveryBehavior, BHV_ConstantHeading);

}  // namespace
}  // namespace limpet
