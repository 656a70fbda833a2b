// SPDX-License-Identifier: MIT
#include "behaviors/BHV_TestFailure.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/clock.hpp"
#include "tests/support/helm_flight.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string FailureBlock(const std::string& lines) {
  return "Behavior = BHV_TestFailure\n{\n  name = fails\n  duration = 0.15\n"
         "  endflag = OVER = true\n" +
         lines + "}\n";
}

TEST(BhvTestFailure, ThrowsAsItCompletesAndIsGoneThenLikeAnyOther) {
  HelmFlight flight(FailureBlock(""));
  flight.Tick();
  EXPECT_THAT(flight.host().TakeFailures(), IsEmpty()) << "before its duration is over";
  flight.Fly(0.3);
  EXPECT_THAT(flight.host().TakeFailures(),
              ElementsAre(BehaviorFailure{"fails", "it has thrown: failure_type = crash"}));
  EXPECT_THAT(flight.Posts("OVER"), ElementsAre("true"));
  EXPECT_THAT(flight.host().statuses(), IsEmpty());
}

TEST(BhvTestFailure, KeepsTheHelmForAsLongAsItIsTold) {
  for (const char* line : {"burn,0.05", "Hang, 0.05"}) {
    HelmFlight flight(FailureBlock("  failure_type = " + std::string(line) + "\n"));
    const Seconds begin = SteadyTime();
    flight.Fly(0.3);
    EXPECT_GE((SteadyTime() - begin).value(), 0.05) << line;
    EXPECT_THAT(flight.host().TakeFailures(), IsEmpty());
    EXPECT_THAT(flight.Posts("OVER"), ElementsAre("true"));
  }
}

TEST(BhvTestFailure, RefusesAFailureThatItDoesNotKnow) {
  for (const char* type : {"explode", "burn,", "burn,-1", "burn,long", "crash,3", "hang 3"}) {
    try {
      HelmFlight flight(FailureBlock("  failure_type = " + std::string(type) + "\n"));
      ADD_FAILURE() << type;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("flight.bhv:6: failure_type: ")) << type;
      EXPECT_THAT(error.what(), HasSubstr("crash, burn or hang")) << type;
    }
  }
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvTestFailure, EveryBehavior, BHV_TestFailure);

}  // namespace
}  // namespace limpet
