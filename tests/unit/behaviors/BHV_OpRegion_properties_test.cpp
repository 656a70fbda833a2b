// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "behaviors/BHV_OpRegion.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"
#include "tests/unit/behaviors/view_behavior_fixture.hpp"

namespace limpet {
namespace {

TEST(BhvOpRegion, PullsToTheMiddleOnlyWhereNoPathLeadsBack) {
  Random random(6, "outside");
  for (int run = 0; run < 100; ++run) {
    BHV_OpRegion behavior({});
    VehicleState state;
    state.area = SurveyArea{-10.0, 10.0, -20.0, 20.0, 2.0, 2.0};
    behavior.Start(state);
    static_cast<void>(behavior.Move(state));  // inside: in force from now on
    const double bearing = random.Uniform(-3.1, 3.1);
    state.nav.north = 40.0 * std::cos(bearing);
    state.nav.east = 40.0 * std::sin(bearing);
    const MotionBid bid = behavior.Move(state);
    ASSERT_TRUE(bid.warning && bid.course);
    EXPECT_NEAR(WrapAngle(bid.course->summit - bearing - std::numbers::pi), 0.0, 1e-9);
    state.guidance = Guidance{.purpose = "beam"};
    EXPECT_FALSE(behavior.Move(state).course);
    EXPECT_TRUE(behavior.Move(state).warning);
  }
}

TEST(BhvOpRegion, RaisesNoAlarmWithinItsTolerance) {
  BHV_OpRegion::Params params;
  params.tolerance = Meters(1.5);
  BHV_OpRegion behavior(params);
  VehicleState state;
  state.area = SurveyArea{-10.0, 10.0, -10.0, 10.0, 2.0, 2.0};
  behavior.Start(state);
  static_cast<void>(behavior.Move(state));
  for (const double beyond : {0.1, 0.7, 1.4, 1.6, 5.0}) {
    state.nav.north = 12.0 + beyond;
    EXPECT_EQ(behavior.Move(state).warning.has_value(), beyond > 1.5) << beyond;
  }
}

using BhvOpRegionViews = ViewBehaviorTest;

TEST_F(BhvOpRegionViews, VetoesExactlyWhatLeavesTheRegion) {
  const BHV_OpRegion behavior({});
  Random random(3, "region");
  int vetoes = 0;
  for (int run = 0; run < 500; ++run) {
    now_.pose = {random.Uniform(-38.0, 38.0), random.Uniform(-38.0, 38.0),
                 random.Uniform(-std::numbers::pi, std::numbers::pi)};
    const Option option{.source = "beam",
                        .path = DubinsPath(now_.pose, {{random.Uniform(-0.3, 0.3), 12.0},
                                                       {random.Uniform(-0.3, 0.3), 12.0}})};
    bool leaves = false;
    double nearest = 1e9;  // to the border, by small steps
    option.path.Sample(0.05, [&](const Pose2& pose, double) {
      const double beyond = std::max(std::abs(pose.north), std::abs(pose.east)) - 42.0;
      leaves = leaves || beyond > 0.0;
      nearest = std::min(nearest, std::abs(beyond));
    });
    const bool has_veto = behavior.Value(Seen(option), now_)->veto.has_value();
    vetoes += has_veto ? 1 : 0;
    if (nearest > 0.01) {
      EXPECT_EQ(has_veto, leaves);
    }
  }
  EXPECT_GT(vetoes, 50);
  EXPECT_LT(vetoes, 450);
}

}  // namespace
}  // namespace limpet
