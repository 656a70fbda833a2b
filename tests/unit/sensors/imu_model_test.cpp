// SPDX-License-Identifier: MIT
#include "limpet/sensors/imu_model.hpp"

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "tests/unit/sensors/at_rest.hpp"
#include "tests/unit/sensors/statistics.hpp"

namespace limpet {
namespace {

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

}  // namespace
}  // namespace limpet
