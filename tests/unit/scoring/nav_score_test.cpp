// SPDX-License-Identifier: MIT
#include "limpet/scoring/nav_score.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr int kPoses = 200;

/// A winding dive: its truth, and an estimate that is off by what `error` says at each pose.
template <typename Error>
SessionRecord DiveWith(std::uint64_t seed, const Error& error, float sd = 0.1F) {
  SessionRecord record("discovery");
  Random random(seed);
  Pose X_WB;
  for (int i = 0; i < kPoses; ++i) {
    X_WB.yaw = WrapAngle(X_WB.yaw + random.Normal(0.2));
    X_WB.p_WB += Eigen::Vector3d(0.5 * std::cos(X_WB.yaw), 0.5 * std::sin(X_WB.yaw), 0.01);
    const Seconds time(static_cast<double>(i));
    record.truth.Add(time, X_WB);
    Pose estimate = X_WB;
    estimate.p_WB = error(X_WB.p_WB, random);
    record.nav.Add(time, estimate);
    record.nav_sd.push_back({sd, sd, sd, 0.01F});
  }
  return record;
}

/// A dive of one seed and one common offset.
class CommonOffsetTest : public ::testing::TestWithParam<int> {};

TEST_P(CommonOffsetTest, IsFoundWhateverTheTurnAndTheShiftAre) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  const double yaw = random.Uniform(-3.0, 3.0);
  const Eigen::Vector3d shift(random.Uniform(-50.0, 50.0), random.Uniform(-50.0, 50.0),
                              random.Uniform(-2.0, 2.0));
  const Eigen::AngleAxisd turn(yaw, Eigen::Vector3d::UnitZ());
  const SessionRecord record = DiveWith(
      static_cast<std::uint64_t>(GetParam()),
      [&](const Eigen::Vector3d& p_W, Random&) { return Eigen::Vector3d(turn * p_W + shift); });
  const NavScore score = ScoreNavigation(record, 0.0);
  EXPECT_NEAR(WrapAngle(score.offset.yaw + yaw), 0.0, 1e-9);
  EXPECT_LT(score.aligned_rmse_m.value(), 1e-9);
  const Eigen::Vector3d p_W(3.0, -4.0, 5.0);
  EXPECT_LT((score.offset.Apply(turn * p_W + shift) - p_W).norm(), 1e-9);
}

TEST_P(CommonOffsetTest, NeverMakesTheErrorLarger) {
  const SessionRecord record = DiveWith(
      static_cast<std::uint64_t>(GetParam()), [](const Eigen::Vector3d& p_W, Random& random) {
        return Eigen::Vector3d(
            p_W + Eigen::Vector3d(random.Normal(0.4), random.Normal(0.2), random.Normal(0.1)));
      });
  const NavScore score = ScoreNavigation(record, 0.0);
  EXPECT_LE(score.aligned_rmse_m.value(), score.position_rmse_m.value() + 1e-12);
}

TEST_P(CommonOffsetTest, TakesAwayNothingThatIsNoise) {
  const double sigma = 0.3;
  const SessionRecord record = DiveWith(
      static_cast<std::uint64_t>(GetParam()), [&](const Eigen::Vector3d& p_W, Random& random) {
        return Eigen::Vector3d(p_W + Eigen::Vector3d(random.Normal(sigma), random.Normal(sigma),
                                                     random.Normal(sigma)));
      });
  const NavScore score = ScoreNavigation(record, 0.0);
  EXPECT_NEAR(score.aligned_rmse_m.value(), std::sqrt(3.0) * sigma, 0.06);
}

TEST_P(CommonOffsetTest, OfErrorsThatTheDeviationTellsTheNeesIsThree) {
  const float sd = 0.25F;
  const SessionRecord record = DiveWith(
      static_cast<std::uint64_t>(GetParam()),
      [&](const Eigen::Vector3d& p_W, Random& random) {
        return Eigen::Vector3d(
            p_W + Eigen::Vector3d(random.Normal(0.25), random.Normal(0.25), random.Normal(0.25)));
      },
      sd);
  // Mean of 600 chi-squared variables of one degree of freedom each, times three: sigma 0.17.
  EXPECT_NEAR(ScoreNavigation(record, 0.0).nees_mean.value(), 3.0, 0.7);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CommonOffsetTest, ::testing::Range(1, 9));

SessionRecord ConstantlyOff(const Eigen::Vector3d& offset, float sd = 0.1F) {
  return DiveWith(
      3, [&](const Eigen::Vector3d& p_W, Random&) { return Eigen::Vector3d(p_W + offset); }, sd);
}

TEST(NavScore, NeesGrowsWithTheSquareOfWhatIsClaimedTooSmall) {
  const double claimed =
      ScoreNavigation(ConstantlyOff({0.3, 0.0, 0.0}, 0.3F), 0.0).nees_mean.value();
  const double tenth =
      ScoreNavigation(ConstantlyOff({0.3, 0.0, 0.0}, 0.03F), 0.0).nees_mean.value();
  EXPECT_NEAR(tenth / claimed, 100.0, 1e-3);
}

TEST(NavScore, HasNoNeesWithoutDeviations) {
  EXPECT_FALSE(ScoreNavigation(ConstantlyOff({0.3, 0.0, 0.0}, 0.0F), 0.0).nees_mean);
}

TEST(NavScore, CountsNothingBeforeTheSurveyBegan) {
  SessionRecord record("discovery");
  for (int i = 0; i < 20; ++i) {
    const double t = i;
    const Pose truth{{t, 0.0, 0.0}, 0.0, 0.0, 0.0};
    Pose estimate = truth;
    estimate.p_WB.y() = i < 10 ? 9.0 : 0.1;
    record.truth.Add(Seconds(t), truth);
    record.nav.Add(Seconds(t), estimate);
    record.nav_sd.push_back({0.1F, 0.1F, 0.1F, 0.01F});
  }
  const NavScore score = ScoreNavigation(record, 10.0);
  EXPECT_NEAR(score.position_rmse_m.value(), 0.1, 1e-9);
  EXPECT_EQ(score.curve.time_s.size(), 10U);
  EXPECT_EQ(score.curve.time_s.front(), 0.0);
  EXPECT_NEAR(score.curve.path_m.back(), 9.0, 1e-9);
}

TEST(NavScore, PassesOverEstimatesThatNoTruthIsKnownFor) {
  SessionRecord record = ConstantlyOff({0.0, 0.2, 0.0});
  Pose astray;
  astray.p_WB = {1e4, 1e4, 0.0};
  record.nav.Add(Seconds(kPoses + 50.0), astray);
  record.nav_sd.push_back({0.1F, 0.1F, 0.1F, 0.01F});
  const NavScore score = ScoreNavigation(record, 0.0);
  EXPECT_NEAR(score.position_rmse_m.value(), 0.2, 1e-9);
  EXPECT_NEAR(score.final_error_m.value(), 0.2, 1e-9);
}

TEST(NavScore, ErrorsOfTheCurveAreThoseOfTheSum) {
  const NavScore score = ScoreNavigation(ConstantlyOff({0.3, -0.4, 0.0}), 0.0);
  for (std::size_t i = 0; i < score.curve.error_m.size(); ++i) {
    ASSERT_NEAR(score.curve.error_m[i], 0.5, 1e-9);
    ASSERT_NEAR(score.curve.north_m[i], 0.3, 1e-9);
    ASSERT_NEAR(score.curve.east_m[i], -0.4, 1e-9);
  }
  EXPECT_NEAR(score.position_rmse_m.value(), 0.5, 1e-9);
}

}  // namespace
}  // namespace limpet
