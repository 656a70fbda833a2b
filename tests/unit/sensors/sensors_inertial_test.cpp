// SPDX-License-Identifier: MIT
// IMU, FOG, depth: what their samples look like in the long run.
#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/sensors/depth_model.hpp"
#include "limpet/sensors/fog_model.hpp"
#include "limpet/sensors/imu_model.hpp"
#include "limpet/sensors/sample_clock.hpp"
#include "tests/unit/sensors/statistics.hpp"

namespace limpet {
namespace {

SimTruth AtRest() {
  SimTruth truth;
  truth.yaw = 1.0;
  truth.down = 3.5;
  truth.fz = -9.81;
  return truth;
}

/// Spread of the mean heading error over sessions.
TEST(ImuModel, HeadingErrorIsNearlyConstantInASessionAndDiffersBetweenSessions) {
  Statistics between;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    ImuModel imu({}, Random(seed));
    Statistics within;
    for (int i = 0; i < 200; ++i) {
      within.Add(WrapAngle(imu.Sample(AtRest(), Seconds(0.5 * i))->heading - 1.0));
    }
    ASSERT_LT(within.sigma(), RadiansFromDegrees(0.4));
    between.Add(within.mean());
  }
  EXPECT_NEAR(between.sigma(), RadiansFromDegrees(0.5), RadiansFromDegrees(0.08));
  EXPECT_NEAR(between.mean(), 0.0, RadiansFromDegrees(0.1));
}

TEST(ImuModel, FeelsGravityUpwardsWithItsStatedNoise) {
  ImuModel imu({}, Random(1));
  Statistics z;
  for (int i = 0; i < 5000; ++i)
    z.Add(imu.Sample(AtRest(), Seconds(0.02 * i))->fz);
  EXPECT_NEAR(z.mean(), -9.81, 0.06);
  EXPECT_NEAR(z.sigma(), 0.01, 0.001);
}

TEST(FogModel, WalksInAngleAsStated) {
  Statistics angles;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    FogModel fog({.bias_deg_per_h = 0.0}, Random(seed));
    double angle = 0.0;
    for (int i = 0; i < 50 * 25; ++i)
      angle += 0.02 * *fog.Sample(AtRest(), Seconds(0.02 * i));
    angles.Add(angle);
  }
  EXPECT_NEAR(angles.sigma(), 3.5e-6 * 5.0, 2e-6);
}

TEST(FogModel, KeepsItsBiasForASession) {
  Statistics biases;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    FogModel fog({.random_walk = 0.0}, Random(seed));
    const double bias = *fog.Sample(AtRest(), Seconds(0.0));
    ASSERT_EQ(*fog.Sample(AtRest(), Seconds(600.0)), bias);
    biases.Add(bias);
  }
  EXPECT_NEAR(biases.sigma(), RadiansFromDegrees(1.0) / 3600.0, 6e-7);
}

TEST(DepthModel, HasTwoCentimetresOfNoiseAboutABiasOfOne) {
  Statistics biases;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    DepthModel depth({}, Random(seed));
    Statistics samples;
    for (int i = 0; i < 400; ++i)
      samples.Add(*depth.Sample(AtRest(), Seconds(0.05 * i)));
    ASSERT_NEAR(samples.sigma(), 0.02, 0.004);
    biases.Add(samples.mean() - 3.5);
  }
  EXPECT_NEAR(biases.sigma(), 0.01, 0.002);
}

TEST(SampleClock, GivesItsRateOnAverageFromAFasterTruth) {
  SampleClock clock(Hertz(20.0));
  int due = 0;
  for (int i = 0; i < 5000; ++i)
    due += clock.IsDue(Seconds(1767225600.0 + i / 50.0)) ? 1 : 0;
  EXPECT_EQ(due, 2000);
}

TEST(SampleClock, TakesEveryTruthAtTheTruthsOwnRate) {
  SampleClock clock(Hertz(50.0));
  for (int i = 0; i < 5000; ++i)
    ASSERT_TRUE(clock.IsDue(Seconds(1767225600.0 + i / 50.0))) << i;
}

}  // namespace
}  // namespace limpet
