// SPDX-License-Identifier: MIT
#include "behaviors/BHV_Timer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/behavior_block.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

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

TEST(BhvTimer, CountsHowLongItHasRunAndBeenIdleAndBidsOnNothing) {
  HelmFlight flight(BehaviorBlock("BHV_Timer",
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
  HelmFlight flight(BehaviorBlock("BHV_Timer", "  duration = 5\n  duration_reset = AGAIN\n"));
  flight.Fly(4.0);
  flight.Say("AGAIN", 1.0);
  flight.Fly(4.0);
  EXPECT_LT(std::stod(flight.Last("TIMER_RUNNING")), 4.2);
  EXPECT_THAT(flight.host().statuses(), SizeIs(1));
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvTimer, EveryBehavior, BHV_Timer);

}  // namespace
}  // namespace limpet
