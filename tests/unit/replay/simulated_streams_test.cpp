// SPDX-License-Identifier: MIT
// The estimator on simulated sessions that are harder than the recorded ones.
#include <algorithm>
#include <limits>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "estimation/smoothing/batch_solver.hpp"
#include "tests/support/simulated_stream.hpp"

namespace limpet {
namespace {

double NoClock() { return 0.0; }

StreamScene RoughHour(std::uint64_t seed) {
  return {.seed = seed,
          .duration_s = 3600.0,
          .half_size_m = 30.0,
          .objects = 14,
          .classes = 2,
          .is_rough = true,
          .tilt_deg = 0.0,
          .altitude_m = 3.5,
          .false_share = 0.6,
          .yaw_bias_degph = 4.0,
          .long_dropouts = 5};
}

TEST(SimulatedStream, IsTheSameForTheSameSeed) {
  const SimulatedStream a = SimulateStream({.seed = 4, .duration_s = 60.0});
  const SimulatedStream b = SimulateStream({.seed = 4, .duration_s = 60.0});
  ASSERT_EQ(a.stream.rows.size(), b.stream.rows.size());
  EXPECT_EQ(a.truth.p.back(), b.truth.p.back());
}

class HardHour : public ::testing::TestWithParam<int> {};

TEST_P(HardHour, LongDropoutsAndFalseBoxesNeitherDoubleNorInventAnObject) {
  const SimulatedStream session = SimulateStream(RoughHour(static_cast<unsigned>(GetParam())));
  const ReplayResult result = Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
  const auto error = ErrorOf(result.smoothed, session.truth);
  const auto objects = ErrorsOf(result.landmarks, error.alignment, session.truth);
  EXPECT_EQ(objects.duplicates, 0);
  EXPECT_EQ(objects.false_ones, 0);
  EXPECT_LT(error.aligned, 0.25);
}

INSTANTIATE_TEST_SUITE_P(Seeds, HardHour, ::testing::Range(1, 5));

StreamScene TwinHour(std::uint64_t seed) {
  StreamScene scene = RoughHour(seed);
  scene.has_twins = true;
  scene.yaw_bias_degph = 2.0;
  scene.false_share = 0.5;
  scene.look_alikes = 6;
  scene.long_dropouts = 1;
  return scene;
}

/// Pairs of identical objects 1.1 m apart, first seen again after most of an hour.
class TwinHourTest : public ::testing::TestWithParam<int> {};

TEST_P(TwinHourTest, TwinsAreNeverTakenForEachOtherForGood) {
  const SimulatedStream session = SimulateStream(TwinHour(static_cast<unsigned>(GetParam())));
  const ReplayResult result = Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
  const auto error = ErrorOf(result.smoothed, session.truth);
  EXPECT_EQ(ErrorsOf(result.landmarks, error.alignment, session.truth).duplicates, 0);
  EXPECT_LT(error.aligned, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TwinHourTest, ::testing::Values(3, 9, 10, 12, 15));

TEST(SimulatedStream, CovariancesAreHonestOverManySessions) {
  constexpr int kSessions = 20;
  double pose = 0.0, landmark = 0.0;
  for (int seed = 1; seed <= kSessions; ++seed) {
    const SimulatedStream session = SimulateStream({.seed = static_cast<unsigned>(seed)});
    const ReplayResult result =
        Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
    const Eigen::Vector3d error =
        result.online.back().X_WB.p_WB - session.truth.At(result.online.back().t);
    pose += error.dot(result.online_covariance.back().llt().solve(error)) / kSessions;
    double sum = 0.0;
    for (const LandmarkEstimate& l : result.landmarks) {
      double nearest = std::numeric_limits<double>::infinity();
      Eigen::Vector3d off = Eigen::Vector3d::Zero();
      for (const TrueLandmark& truth : session.truth.landmarks) {
        if ((truth.p - l.p).norm() < nearest) nearest = (truth.p - l.p).norm(), off = truth.p - l.p;
      }
      sum += off.dot(l.covariance.llt().solve(off));
    }
    landmark += sum / static_cast<double>(result.landmarks.size()) / kSessions;
  }
  // 95 % band of the mean of twenty squared errors with three degrees of freedom: 3 +- 1.07.
  EXPECT_NEAR(pose, 3.0, 1.07);
  EXPECT_NEAR(landmark, 3.0, 1.07);
}

TEST(SimulatedStream, EndsWithinHalfAPercentOfTheBatchOptimum) {
  const SimulatedStream session = SimulateStream(RoughHour(3));
  double best = 0.0;
  const ReplayResult result = Replay(session.stream, ParamsForStream(session.stream.meta), NoClock,
                                     [&best](const Navigator& navigator) {
                                       ChainGraph graph = navigator.graph();
                                       best = SolveBatch(graph).cost;
                                     });
  EXPECT_TRUE(result.finish.has_converged);
  EXPECT_LE(result.finish.cost, 1.005 * best);
}

}  // namespace
}  // namespace limpet
