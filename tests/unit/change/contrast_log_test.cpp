// SPDX-License-Identifier: MIT
#include "estimation/change/contrast_log.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// A world of its own: contrast close by, patches and the exponent's factor differ from what the
/// log believes.
struct World {
  double visibility = 8.0;
  double close_by = 0.06;
  double patch = 0.25;
  double folds = 3.0;
  double noise = 0.0024;
};

ContrastLog LogOf(const World& world, double from, double to, Random& random) {
  ContrastLog log;
  for (double range = from; range >= to; range -= 0.05) {
    const double here = world.close_by * std::exp(random.Normal(world.patch));
    const double contrast = here * std::exp(-world.folds * range / world.visibility);
    log.Add(range, {.green = contrast, .noise = world.noise});
  }
  return log;
}

WaterVisibility EstimateFrom(const ContrastLog& log) {
  VisibilityBelief belief(Meters(8.0), 2.0);
  belief.Add(log.LogLikelihood(), 6.0);
  return belief.estimate();
}

TEST(ContrastLog, NothingSeenSaysNothing) {
  const WaterVisibility before = VisibilityBelief(Meters(8.0), 2.0).estimate();
  EXPECT_EQ(EstimateFrom({}).visibility.value(), before.visibility.value());
}

TEST(ContrastLog, GroundThatDoesNotStandOutFromFourMetresMeansMurk) {
  Random random(1);
  const WaterVisibility murky = EstimateFrom(LogOf({.visibility = 2.0}, 7.0, 4.0, random));
  EXPECT_LT(murky.visibility.value(), 5.0);
}

TEST(ContrastLog, GroundThatStandsOutFromFarMeansClearWater) {
  Random random(2);
  const WaterVisibility clear = EstimateFrom(LogOf({.visibility = 12.0}, 7.0, 4.0, random));
  EXPECT_GT(clear.visibility.value(), 7.0);
}

TEST(ContrastLog, IsAsRightAsItSaysOverManyGroundsAndWaters) {
  Random random(3);
  double squares = 0.0;
  constexpr int kWorlds = 150;
  for (int i = 0; i < kWorlds; ++i) {
    const World world{.visibility = 8.0 * std::exp(random.Normal(0.6)),
                      .close_by = 0.05 * std::exp(random.Normal(0.7)),
                      .patch = random.Uniform(0.1, 0.5),
                      .folds = 3.0 * std::exp(random.Normal(0.2)),
                      .noise = 0.0024 * std::exp(random.Normal(0.5))};
    const WaterVisibility said = EstimateFrom(LogOf(world, 7.5, 3.5, random));
    const double off = std::log(world.visibility / said.visibility.value());
    squares += std::pow(off / (said.sd / said.visibility), 2) / kWorlds;
  }
  EXPECT_LT(squares, 1.5);
  EXPECT_GT(squares, 0.2);  // and does not hide behind sigmas
}

TEST(ContrastLog, OnePlaceLookedAtForHoursIsOneWitness) {
  Random random(4);
  ContrastLog once = LogOf({.visibility = 5.0, .patch = 0.0}, 4.1, 4.05, random);
  ContrastLog often = once;
  for (int i = 0; i < 5000; ++i) {
    often.Add(4.1, {.green = 0.06 * std::exp(-3.0 * 4.1 / 5.0), .noise = 0.0024});
  }
  EXPECT_NEAR(EstimateFrom(often).visibility.value(), EstimateFrom(once).visibility.value(), 0.3);
}

TEST(ContrastLog, WhatIsNoMeasurementIsLeftOut) {
  ContrastLog log;
  log.Add(std::nan(""), {.green = 0.1, .noise = 0.01});
  log.Add(-1.0, {.green = 0.1, .noise = 0.01});
  log.Add(3.0, {.green = std::nan(""), .noise = 0.01});
  EXPECT_TRUE(log.bins().empty());
  log.Set({{.from = 1.0, .clear = -3, .faint = 4}, {.from = 2.0}});
  EXPECT_TRUE(log.bins().empty());
}

}  // namespace
}  // namespace limpet
