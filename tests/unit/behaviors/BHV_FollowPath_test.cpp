// SPDX-License-Identifier: MIT
#include "behaviors/BHV_FollowPath.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/behaviors/every_behavior.hpp"

namespace limpet {
namespace {

TEST(BhvFollowPath, PassesOnTheGuidanceAtSurveySpeed) {
  BHV_FollowPath behavior({});
  VehicleState state;
  state.guidance = Guidance{.course = 1.2, .turn_rate = 0.1};
  const MotionBid bid = behavior.Move(state);
  EXPECT_DOUBLE_EQ(bid.course->summit, 1.2);
  EXPECT_DOUBLE_EQ(*bid.turn_rate, 0.1);
  EXPECT_DOUBLE_EQ(bid.speed->summit, 0.5);
}

TEST(BhvFollowPath, HasNoOpinionWithoutAPath) {
  BHV_FollowPath behavior({});
  EXPECT_FALSE(behavior.Move(VehicleState{}).course.has_value());
}

TEST(BhvFollowPath, TurnsAsTheGuidanceSaysAtItsOwnSpeed) {
  Random random(3, "guidance");
  for (int run = 0; run < 100; ++run) {
    BHV_FollowPath::Params params;
    params.speed = MetersPerSecond(random.Uniform(0.1, 2.0));
    BHV_FollowPath behavior(params);
    VehicleState state;
    state.guidance =
        Guidance{.course = random.Uniform(-3.1, 3.1), .turn_rate = random.Uniform(-0.3, 0.3)};
    const MotionBid bid = behavior.Move(state);
    EXPECT_EQ(bid.course->summit, state.guidance->course);
    EXPECT_EQ(*bid.turn_rate, state.guidance->turn_rate);
    EXPECT_EQ(bid.speed->summit, params.speed.value());
    EXPECT_FALSE(bid.depth);
  }
}

INSTANTIATE_TYPED_TEST_SUITE_P(BhvFollowPath, EveryBehavior, BHV_FollowPath);

}  // namespace
}  // namespace limpet
