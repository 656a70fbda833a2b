// SPDX-License-Identifier: MIT
#include "limpet/sensors/fog_model.hpp"

#include <gtest/gtest.h>

#include "tests/unit/sensors/at_rest.hpp"
#include "tests/unit/sensors/statistics.hpp"

namespace limpet {
namespace {

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

}  // namespace
}  // namespace limpet
