// SPDX-License-Identifier: MIT
// The change posterior where something may only look like an object, by enumerating all that may
// be.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "estimation/change/status.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// What two sessions saw of a place, in any water.
struct Seen {
  StatusPriors priors;
  double former = 0.0;     ///< Lambda of the former session
  double present = 0.0;    ///< ln P(seen now | object) / P(seen now | bare)
  double lookalike = 0.0;  ///< likewise of a lookalike
};

Seen DrawSeen(Random& random) {
  return {.priors = {.presence = random.Uniform(0.005, 0.4),
                     .survival = random.Uniform(0.1, 0.9),
                     .appearance = random.Uniform(0.005, 0.4),
                     .lookalike = random.Uniform(1e-4, 0.1),
                     .lookalike_survival = random.Uniform(0.1, 1.0),
                     .decide_at = 0.9},
          .former = random.Uniform(-6.0, 6.0),
          .present = random.Uniform(-6.0, 6.0),
          .lookalike = random.Uniform(-6.0, 6.0)};
}

class LookalikeStatus : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "lookalike"};
  const VisibilityBelief water_{Meters(8.0), 2.0};
  [[nodiscard]] StatusPosterior Posterior(const Seen& seen) const {
    return ChangeStatus(seen.former, {.present = seen.present, .lookalike = seen.lookalike}, water_,
                        seen.priors);
  }
};

TEST_P(LookalikeStatus, IsBayesRuleOverObjectLookalikeAndBareSeabed) {
  for (int i = 0; i < 100; ++i) {
    const Seen seen = DrawSeen(random_);
    const StatusPriors& p = seen.priors;
    // Without an object then, what the former session saw was a lookalike with this chance; it may
    // still be there, or another may have come.
    const double then = std::min(1.0, p.lookalike * std::exp(seen.former));
    const double still = p.lookalike_survival * then;
    const double either = std::min(still + (1.0 - still) * p.lookalike, 1.0 - 1e-9);
    const auto absent = [&](double chance) {
      return 1.0 - chance + chance * std::exp(seen.lookalike);
    };
    const double was = p.presence * std::exp(seen.former), was_not = 1.0 - p.presence;
    const StatusPosterior weights{.confirmed = was * p.survival * std::exp(seen.present),
                                  .removed = was * (1.0 - p.survival) * absent(p.lookalike),
                                  .appeared = was_not * p.appearance * std::exp(seen.present),
                                  .nothing = was_not * (1.0 - p.appearance) * absent(either)};
    const StatusPosterior expected = weights.Normalized(), got = Posterior(seen);
    EXPECT_NEAR(got.confirmed, expected.confirmed, 1e-9);
    EXPECT_NEAR(got.removed, expected.removed, 1e-9);
    EXPECT_NEAR(got.appeared, expected.appeared, 1e-9);
    EXPECT_NEAR(got.nothing, expected.nothing, 1e-9);
  }
}

TEST_P(LookalikeStatus, WhereNothingLooksLikeAnObjectItIsThePlainRule) {
  for (int i = 0; i < 50; ++i) {
    Seen seen = DrawSeen(random_);
    seen.priors.lookalike = 1e-300;
    const StatusPosterior plain =
        ChangeStatus({.former = seen.former, .now = seen.present}, seen.priors);
    const StatusPosterior got = Posterior(seen);
    EXPECT_NEAR(got.confirmed, plain.confirmed, 1e-9);
    EXPECT_NEAR(got.removed, plain.removed, 1e-9);
    EXPECT_NEAR(got.appeared, plain.appeared, 1e-9);
  }
}

TEST_P(LookalikeStatus, WaterOfWhichLooksDependIsAveragedNotGuessed) {
  for (int i = 0; i < 50; ++i) {
    const Seen seen = DrawSeen(random_);
    PlaceEvidence evidence{.present = seen.present, .lookalike = seen.lookalike};
    for (int k = 0; k < PerVisibility::kCount; ++k)
      evidence.present(k) += 0.2 * k;
    StatusPosterior expected{.confirmed = 0.0, .removed = 0.0, .appeared = 0.0, .nothing = 0.0};
    for (int k = 0; k < PerVisibility::kCount; ++k) {
      const PlaceEvidence in_it{.present = evidence.present(k), .lookalike = seen.lookalike};
      expected.Add(ChangeStatus(seen.former, in_it, water_, seen.priors), water_.chances()(k));
    }
    const StatusPosterior got = ChangeStatus(seen.former, evidence, water_, seen.priors);
    EXPECT_NEAR(got.confirmed, expected.confirmed, 1e-9);
    EXPECT_NEAR(got.nothing, expected.nothing, 1e-9);
    EXPECT_NEAR(got.sum(), 1.0, 1e-9);
  }
}

TEST_P(LookalikeStatus, TheOneLambdaLeadsToTheChanceThatTheWaterGives) {
  for (int i = 0; i < 50; ++i) {
    const Seen seen = DrawSeen(random_);
    PerVisibility lambda = seen.present;
    for (int k = 0; k < PerVisibility::kCount; ++k)
      lambda(k) += random_.Normal(2.0);
    const double one = LambdaIn(water_, lambda, seen.priors);
    double mean = 0.0;
    for (int k = 0; k < PerVisibility::kCount; ++k)
      mean += water_.chances()(k) * DiscoveryStatus(lambda(k), seen.priors).appeared;
    EXPECT_NEAR(DiscoveryStatus(one, seen.priors).appeared, mean, 1e-9);
    EXPECT_GE(one, lambda.minCoeff() - 1e-9);
    EXPECT_LE(one, lambda.maxCoeff() + 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, LookalikeStatus, ::testing::Range(1, 7));

}  // namespace
}  // namespace limpet
