// SPDX-License-Identifier: MIT
// What contrasts say of the water where every number of the model decides.
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/contrast_log.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kUsualGround = -2.8;  // ln of its contrast close by, as docs/water.md has it

/// An image from `range` in water of this visibility, which leaves 5 % of the ground's contrast.
GroundContrast ImageFrom(double range, double visibility, double ground = kUsualGround) {
  return {.green = std::exp(ground - 3.0 * range / visibility), .noise = 1e-9};
}

int BestOf(const PerVisibility& log_likelihood) {
  Eigen::Index best = 0;
  static_cast<void>(log_likelihood.maxCoeff(&best));
  return static_cast<int>(best);
}

class ContrastLogProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "contrast"};
};

TEST_P(ContrastLogProperties, ImagesFromManyDistancesFindTheVisibilityItself) {
  for (const int truth : {6, 9, 12, 15}) {
    const double visibility = VisibilityBelief::Grid()(truth);
    ContrastLog log;
    for (double range = 0.625; range < 8.0; range += 0.25)
      log.Add(range, ImageFrom(range, visibility, kUsualGround + random_.Normal(0.02)));
    EXPECT_EQ(BestOf(log.LogLikelihood()), truth);
  }
}

TEST_P(ContrastLogProperties, OneDistanceTellsNoMoreThanGroundAndPatchLeave) {
  // Sites differ by 0.7 in the logarithm; one distance by 0.35, and counts for half.
  const double variance = 0.7 * 0.7 + 0.35 * 0.35 / 0.5;
  const double range = 0.125 + 0.25 * static_cast<double>(4 + random_.Index(20));
  const double visibility = random_.Uniform(3.0, 15.0);
  ContrastLog log;
  log.Add(range, ImageFrom(range, visibility));
  const PerVisibility said = log.LogLikelihood();
  const PerVisibility expected = VisibilityBelief::Grid().unaryExpr([&](double v) {
    const double off = 3.0 * range / visibility - 3.0 * range / v;
    return -0.5 * off * off / variance;
  });
  const int at = BestOf(expected);
  for (int i = 0; i < PerVisibility::kCount; ++i) {
    if (expected(i) < expected(at) - 2.0) continue;  // where the sum over grounds ends
    EXPECT_NEAR(said(i) - said(at), expected(i) - expected(at), 0.06);
  }
}

TEST_P(ContrastLogProperties, WhatIsNotTwiceTheNoiseIsNotTheGrounds) {
  for (int i = 0; i < 50; ++i) {
    const double noise = random_.Uniform(1e-4, 1e-2), range = random_.Uniform(0.3, 9.0);
    ContrastLog log;
    log.Add(range, {.green = 2.001 * noise, .noise = noise});
    log.Add(range, {.green = 1.999 * noise, .noise = noise});
    ASSERT_EQ(log.bins().size(), 1U);
    EXPECT_EQ(log.bins()[0].clear, 1);
    EXPECT_EQ(log.bins()[0].faint, 1);
    EXPECT_NEAR(log.bins()[0].log_contrast, std::log(2.001 * noise), 1e-9);
    EXPECT_NEAR(log.bins()[0].log_limit, std::log(2.0 * noise), 1e-9);
  }
}

TEST_P(ContrastLogProperties, ImagesOfOneQuarterOfAMetreAreOneWitness) {
  const double from = 0.25 * static_cast<double>(2 + random_.Index(20));
  ContrastLog once, often;
  once.Add(from + 0.1, ImageFrom(from, 8.0));
  for (int i = 0; i < 40; ++i)
    often.Add(from + random_.Uniform(0.0, 0.249), ImageFrom(from, 8.0));
  ASSERT_EQ(often.bins().size(), 1U);
  EXPECT_EQ(often.bins()[0].from, from);
  EXPECT_EQ(often.bins()[0].clear, 40);
  EXPECT_TRUE(often.LogLikelihood().isApprox(once.LogLikelihood(), 1e-9));
  often.Add(from + 0.25, ImageFrom(from, 8.0));
  EXPECT_EQ(often.bins().size(), 2U);
}

TEST_P(ContrastLogProperties, FaintGroundSpeaksAgainstClearWaterAndForNoMurk) {
  ContrastLog log;
  for (double range = 2.1; range < 6.0; range += 0.25)
    log.Add(range, {.green = 0.0, .noise = random_.Uniform(0.002, 0.004)});
  const PerVisibility said = log.LogLikelihood();
  for (int i = 1; i < PerVisibility::kCount; ++i)
    EXPECT_LE(said(i), said(i - 1) + 1e-9);
  EXPECT_GT(said(0) - said(PerVisibility::kCount - 1), 3.0);
}

TEST_P(ContrastLogProperties, WhatIsKeptSaysTheSameInAnyOrder) {
  ContrastLog log;
  for (int i = 0; i < 60; ++i) {
    const double range = random_.Uniform(0.5, 8.0);
    log.Add(range, ImageFrom(range, 6.0, kUsualGround + random_.Normal(0.3)));
  }
  std::vector<ContrastBin> kept(log.bins().rbegin(), log.bins().rend());
  kept.push_back({.from = 3.0, .clear = 0, .faint = 0});
  kept.push_back({.from = 4.0, .clear = -1, .faint = 2});
  ContrastLog other;
  other.Set(kept);
  EXPECT_EQ(other.bins().size(), log.bins().size()) << "what no log keeps is left out";
  EXPECT_TRUE(other.LogLikelihood().isApprox(log.LogLikelihood(), 1e-12));
}

INSTANTIATE_TEST_SUITE_P(Drawn, ContrastLogProperties, ::testing::Range(1, 9));

TEST(ContrastLog, NoiseThatNobodyMeasuredIsNotNothing) {
  ContrastLog log;
  log.Add(1.0, {.green = 2.1e-5, .noise = 0.0});
  log.Add(1.0, {.green = 1.9e-5, .noise = 0.0});
  ASSERT_EQ(log.bins().size(), 1U);
  EXPECT_EQ(log.bins()[0].clear, 1);
  EXPECT_EQ(log.bins()[0].faint, 1);
}

}  // namespace
}  // namespace limpet
