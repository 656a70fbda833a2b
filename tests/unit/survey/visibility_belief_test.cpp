// SPDX-License-Identifier: MIT
#include "limpet/survey/visibility_belief.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/survey/detection_chance.hpp"

namespace limpet {
namespace {

constexpr double kAny = 100.0;  ///< of evidence, so much that nothing is cut off

TEST(VisibilityBelief, StartsFromWhatWasExpected) {
  const WaterVisibility start = VisibilityBelief(Meters(8.0), 2.0).estimate();
  EXPECT_NEAR(start.visibility.value(), 8.0, 0.6);
  EXPECT_GT(start.sd.value(), 4.0);
  EXPECT_NEAR(VisibilityBelief(Meters(8.0), 2.0).chances().sum(), 1.0, 1e-12);
}

TEST(VisibilityBelief, LearnsNothingFromWhatAnyWaterWouldShow) {
  VisibilityBelief belief(Meters(8.0), 2.0);
  const VisibilityBelief before = belief;
  for (int i = 0; i < 10; ++i)
    belief.Add(-3.0, kAny);
  EXPECT_TRUE(belief.chances().isApprox(before.chances(), 1e-9));
}

TEST(VisibilityBelief, GivesNoSinglePieceOfEvidenceMoreThanItsBound) {
  VisibilityBelief belief(Meters(8.0), 2.0);
  const PerVisibility before = belief.chances();
  PerVisibility against_clear = 0.0;
  against_clear.tail<12>() = -50.0;
  belief.Add(against_clear, 3.0);
  const auto odds = [](const PerVisibility& chances) {
    return chances.tail<12>().sum() / chances.head<12>().sum();
  };
  EXPECT_NEAR(std::log(odds(before) / odds(belief.chances())), 3.0, 1e-9);
}

/// Boxes of objects at ranges around the reach of sight, drawn from a detector that reaches
/// `reach_factor` times as far as the model has it and fades `fade_factor` times as wide.
WaterVisibility EstimateIn(double visibility, double reach_factor, double fade_factor,
                           Random& random) {
  const DetectionModel model;
  VisibilityBelief belief(Meters(8.0), 2.0);
  for (int i = 0; i < 40; ++i) {
    const double range = random.Uniform(0.2, 2.0) * visibility * reach_factor;
    const double x = (range - 1.1 * reach_factor * visibility) / (0.06 * fade_factor * visibility);
    const bool is_seen = random.Chance(0.95 / (1.0 + std::exp(x)));
    const PerVisibility detects =
        DetectionChances(model, {.range = range, .share = 1.0}, VisibilityBelief::Grid());
    belief.Add(detects.unaryExpr([is_seen](double p) {
      const double mixed = 0.9 * p + 0.1 * 0.05;
      return is_seen ? std::log(mixed) : std::log1p(-mixed);
    }),
               3.0);
  }
  return belief.estimate();
}

TEST(VisibilityBeliefProperties, FindsTheVisibilityWithinItsSigmaWhenTheDetectorIsNotAsBelieved) {
  Random random(29);
  double squares = 0.0;
  constexpr int kWorlds = 200;
  for (int i = 0; i < kWorlds; ++i) {
    const double visibility = 1.5 * std::pow(8.0, random.Uniform(0.0, 1.0));
    const double reach = std::pow(1.4, random.Uniform(-1.0, 1.0));
    const double fade = std::pow(2.0, random.Uniform(-1.0, 1.0));
    const WaterVisibility found = EstimateIn(visibility, reach, fade, random);
    const double error = std::log(found.visibility.value() / visibility);
    const double sigma = found.sd.value() / found.visibility.value();
    squares += error * error / (sigma * sigma);
  }
  EXPECT_LT(squares / kWorlds, 1.2);
  EXPECT_GT(squares / kWorlds, 0.2) << "sigma is far too wide";
}

TEST(VisibilityBeliefProperties, ErrsByLessThanThreeSigmaWhenTheDetectorReachesTwiceAsFar) {
  Random random(31);
  for (const double reach : {0.5, 2.0}) {
    const WaterVisibility found = EstimateIn(4.0, reach, 1.0, random);
    const double error = std::log(found.visibility.value() / 4.0);
    EXPECT_LT(std::abs(error), 3.0 * found.sd.value() / found.visibility.value()) << reach;
  }
}

}  // namespace
}  // namespace limpet
