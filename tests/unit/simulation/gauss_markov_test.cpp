// SPDX-License-Identifier: MIT
// Noise that wanders: its sigma, its memory, and that it does not matter how often it is asked.
#include "limpet/simulation/gauss_markov.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

class GaussMarkovNoise : public ::testing::TestWithParam<double> {
 protected:
  /// Samples `step` seconds apart, of noise of sigma 2 with a memory of 10 s.
  static std::vector<double> Sampled(double step, int count, std::uint64_t seed) {
    Random random(seed);
    GaussMarkov noise(2.0, Seconds(10.0));
    std::vector<double> samples;
    for (int i = 0; i < count; ++i)
      samples.push_back(noise.Sample(Seconds(step * i), random));
    return samples;
  }
};

TEST_P(GaussMarkovNoise, HasItsSigmaHoweverOftenItIsAsked) {
  double sum = 0.0, squares = 0.0;
  const std::vector<double> samples = Sampled(GetParam(), 40000, 1);
  for (const double x : samples)
    sum += x, squares += x * x;
  const auto count = static_cast<double>(samples.size());
  // Neighbours are alike: fewer independent samples than there are.
  const double independent = std::min(count, count * GetParam() / 20.0);
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 2.0 / std::sqrt(independent));
  EXPECT_NEAR(std::sqrt(squares / count), 2.0, 6.0 * 2.0 / std::sqrt(2.0 * independent));
}

TEST_P(GaussMarkovNoise, RemembersItsLastValueForAsLongAsItSays) {
  const std::vector<double> samples = Sampled(GetParam(), 40000, 2);
  double product = 0.0, squares = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    product += samples[i] * samples[i - 1], squares += samples[i] * samples[i];
  EXPECT_NEAR(product / squares, std::exp(-GetParam() / 10.0), 0.03);
}

TEST_P(GaussMarkovNoise, IsTheSameForTheSameSeed) {
  EXPECT_EQ(Sampled(GetParam(), 50, 3), Sampled(GetParam(), 50, 3));
  EXPECT_NE(Sampled(GetParam(), 50, 3), Sampled(GetParam(), 50, 4));
}

INSTANTIATE_TEST_SUITE_P(Steps, GaussMarkovNoise, ::testing::Values(1.0, 5.0, 30.0));

TEST(GaussMarkov, AskedTwiceAtOnceSaysTheSame) {
  Random random(5);
  GaussMarkov noise(1.0, Seconds(10.0));
  const double first = noise.Sample(Seconds(3.0), random);
  EXPECT_NEAR(noise.Sample(Seconds(3.0), random), first, 1e-12);
}

}  // namespace
}  // namespace limpet
