// SPDX-License-Identifier: MIT
#include "behaviors/BHV_GoToDepth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(BhvGoToDepth, GoesFromLevelToLevelAndStaysAtEach) {
  HelmFlight flight(BehaviorBlock("BHV_GoToDepth",
                                  "  depth = 6,20 : 3,10 : 9\n  capture_delta = 0.2\n"
                                  "  arrival_flag = LEVELS\n  endflag = DONE = true\n"));
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("GTD_LEVELS").empty(); }, 60.0));
  EXPECT_NEAR(flight.depth(), 6.0, 0.25);
  const double arrived = flight.time();
  ASSERT_TRUE(flight.FlyUntil([&] { return flight.Posts("GTD_LEVELS").size() == 2; }, 60.0));
  EXPECT_NEAR(flight.time() - arrived, 20.0 + 2.8 / 0.3, 1.0);
  ASSERT_TRUE(flight.FlyUntil([&] { return !flight.Posts("DONE").empty(); }, 90.0));
  EXPECT_THAT(flight.Posts("GTD_LEVELS"), ElementsAre("1", "2", "3"));
  EXPECT_THAT(flight.Posts("LEVEL_DEPTH"), ElementsAre("3", "9"));
}

TEST(BhvGoToDepth, RepeatsItsLevels) {
  HelmFlight flight(BehaviorBlock("BHV_GoToDepth",
                                  "  depth = 3 : 1\n  repeat = 1\n  capture_delta = 0.1\n"
                                  "  capture_flag = N\n  endflag = DONE = true\n"));
  flight.Fly(120.0);
  EXPECT_THAT(flight.Posts("GTD_N"), ElementsAre("1", "2", "3", "4"));
  EXPECT_THAT(flight.Posts("DONE"), SizeIs(1));
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvGoToDepth, EveryBehavior, BHV_GoToDepth);

}  // namespace
}  // namespace limpet
