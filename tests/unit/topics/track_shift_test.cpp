// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

TrackShift RandomShift(Random& random) {
  TrackShift shift;
  double time = random.Uniform(0.0, 5.0);
  for (std::uint64_t steps = 1 + random.Index(6); steps > 0; --steps) {
    shift.steps.push_back({time, random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0),
                           random.Uniform(-0.5, 0.5), random.Uniform(-0.2, 0.2)});
    time += random.Uniform(0.1, 10.0);
  }
  return shift;
}

const Pose kKept{{10.0, -20.0, 3.0}, 0.1, -0.2, 3.1};

TEST(TrackShift, MovesAPoseOfAStepByThatStep) {
  Random random(1, "steps");
  for (int run = 0; run < 100; ++run) {
    const TrackShift shift = RandomShift(random);
    for (const auto& step : shift.steps) {
      const Pose moved = shift.Apply(step[0], kKept);
      EXPECT_LT((moved.p_WB - kKept.p_WB - Eigen::Vector3d(step[1], step[2], step[3])).norm(),
                1e-9);
      EXPECT_NEAR(WrapAngle(moved.yaw - kKept.yaw - step[4]), 0.0, 1e-9);
    }
  }
}

TEST(TrackShift, MovesWhatLiesBetweenAsMuchAsTheWayToTheNextStep) {
  Random random(2, "between");
  for (int run = 0; run < 100; ++run) {
    TrackShift shift = RandomShift(random);
    while (shift.steps.size() < 2)
      shift = RandomShift(random);
    const auto &a = shift.steps[0], &b = shift.steps[1];
    const double share = random.Uniform(0.0, 1.0);
    const Pose moved = shift.Apply(a[0] + share * (b[0] - a[0]), kKept);
    EXPECT_NEAR(moved.p_WB.x() - kKept.p_WB.x(), a[1] + share * (b[1] - a[1]), 1e-9);
    EXPECT_NEAR(moved.p_WB.y() - kKept.p_WB.y(), a[2] + share * (b[2] - a[2]), 1e-9);
  }
}

TEST(TrackShift, MovesWhatIsOlderAsItsFirstStepAndLeavesWhatIsNewer) {
  Random random(3, "ends");
  for (int run = 0; run < 50; ++run) {
    const TrackShift shift = RandomShift(random);
    const Pose oldest = shift.Apply(shift.steps.front()[0] - 100.0, kKept);
    EXPECT_NEAR(oldest.p_WB.x() - kKept.p_WB.x(), shift.steps.front()[1], 1e-9);
    const Pose newer = shift.Apply(shift.steps.back()[0] + 0.01, kKept);
    EXPECT_EQ(newer.p_WB, kKept.p_WB);
    EXPECT_EQ(newer.yaw, kKept.yaw);
  }
}

TEST(TrackShift, KeepsRollPitchAndAYawThatIsWrapped) {
  const TrackShift shift{.steps = {{0.0, 0.0, 0.0, 0.0, 0.2}}};
  const Pose moved = shift.Apply(0.0, kKept);
  EXPECT_EQ(moved.roll, kKept.roll);
  EXPECT_EQ(moved.pitch, kKept.pitch);
  EXPECT_NEAR(moved.yaw, 3.3 - 2.0 * std::acos(-1.0), 1e-12);
}

TEST(TrackShift, WithoutStepsMovesNothing) {
  EXPECT_EQ(TrackShift{}.Apply(5.0, kKept).p_WB, kKept.p_WB);
}

TEST(TrackShift, SaysHowSureAPlaceIsBetweenTheTimesThatItNames) {
  const TrackShift shift{.steps = {}, .sigmas = {{10.0, 0.4, 0.0}, {20.0, 0.6, 0.2}}};
  EXPECT_NEAR(shift.SigmaAt(15.0)->absolute, 0.5, 1e-12);
  EXPECT_NEAR(shift.SigmaAt(15.0)->beside, 0.1, 1e-12);
  EXPECT_EQ(shift.SigmaAt(0.0)->absolute, 0.4) << "older: as the first";
  EXPECT_FALSE(shift.SigmaAt(20.5).has_value()) << "newer: not said";
  EXPECT_FALSE(TrackShift{}.SigmaAt(5.0).has_value());
}

TEST(MappingPhase, IsEveryPhaseInWhichTheGroundIsBelowTheCamera) {
  for (const char* phase : {"", "DIVE", "SURVEY", "RETURN"})
    EXPECT_TRUE(IsMappingPhase(phase));
  for (const char* phase : {"IDLE", "ALIGN", "ASCEND", "FIX", "DONE", "survey"}) {
    EXPECT_FALSE(IsMappingPhase(phase)) << phase;
  }
}

}  // namespace
}  // namespace limpet
