// SPDX-License-Identifier: MIT
#include "limpet/sensors/depth_model.hpp"

#include <gtest/gtest.h>

#include "tests/unit/sensors/at_rest.hpp"
#include "tests/unit/sensors/statistics.hpp"

namespace limpet {
namespace {

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

}  // namespace
}  // namespace limpet
