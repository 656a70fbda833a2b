// SPDX-License-Identifier: MIT
// What must hold of the change posterior whatever the evidence and the priors.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/status.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

struct Case {
  StatusPriors priors;
  double former = 0.0, now = 0.0;
};

Case RandomCase(Random& random) {
  return {.priors = {.presence = random.Uniform(0.001, 0.4),
                     .survival = random.Uniform(0.1, 0.95),
                     .appearance = random.Uniform(0.001, 0.4),
                     .decide_at = 0.9},
          .former = random.Uniform(-12.0, 12.0),
          .now = random.Uniform(-12.0, 12.0)};
}

class ChangeProperties : public ::testing::Test {
 protected:
  template <class Check>
  void ForAll(Check check) {
    Random random(11);
    for (int i = 0; i < 200; ++i)
      check(RandomCase(random));
  }
};

TEST_F(ChangeProperties, ThePosteriorIsBayesRuleOverThePresenceInBothSessions) {
  ForAll([](const Case& c) {
    // Likelihoods of what was seen, given presence, each with that of absence as its unit.
    const double before = std::exp(c.former), after = std::exp(c.now);
    double joint[2][2], total = 0.0;
    for (const int was : {0, 1}) {
      for (const int is : {0, 1}) {
        const double prior_was = was == 1 ? c.priors.presence : 1.0 - c.priors.presence;
        const double stays_or_comes = was == 1 ? c.priors.survival : c.priors.appearance;
        const double prior_is = is == 1 ? stays_or_comes : 1.0 - stays_or_comes;
        joint[was][is] = prior_was * prior_is * (was == 1 ? before : 1.0) * (is == 1 ? after : 1.0);
        total += joint[was][is];
      }
    }
    const StatusPosterior p = ChangeStatus({.former = c.former, .now = c.now}, c.priors);
    EXPECT_NEAR(p.confirmed, joint[1][1] / total, 1e-12);
    EXPECT_NEAR(p.removed, joint[1][0] / total, 1e-12);
    EXPECT_NEAR(p.appeared, joint[0][1] / total, 1e-12);
    EXPECT_NEAR(p.nothing, joint[0][0] / total, 1e-12);
    EXPECT_NEAR(p.present(), p.confirmed + p.appeared, 1e-15);
  });
}

TEST_F(ChangeProperties, NoEvidenceLeavesThePriors) {
  ForAll([](const Case& c) {
    const StatusPosterior p = ChangeStatus({.former = 0.0, .now = 0.0}, c.priors);
    EXPECT_NEAR(p.confirmed + p.removed, c.priors.presence, 1e-12);
    EXPECT_NEAR(p.confirmed, c.priors.presence * c.priors.survival, 1e-12);
    EXPECT_NEAR(p.appeared, (1.0 - c.priors.presence) * c.priors.appearance, 1e-12);
  });
}

TEST_F(ChangeProperties, MoreEvidenceOfPresenceNowNeverMakesPresenceLessLikely) {
  ForAll([](const Case& c) {
    const StatusPosterior less = ChangeStatus({.former = c.former, .now = c.now}, c.priors);
    const StatusPosterior more = ChangeStatus({.former = c.former, .now = c.now + 0.5}, c.priors);
    EXPECT_GT(more.present(), less.present() - 1e-12);
    EXPECT_LT(more.removed, less.removed + 1e-12);
    EXPECT_LT(more.nothing, less.nothing + 1e-12);
  });
}

TEST_F(ChangeProperties, MoreEvidenceOfFormerPresenceNeverMakesItLessLikely) {
  ForAll([](const Case& c) {
    const StatusPosterior less = ChangeStatus({.former = c.former, .now = c.now}, c.priors);
    const StatusPosterior more = ChangeStatus({.former = c.former + 0.5, .now = c.now}, c.priors);
    EXPECT_GT(more.confirmed + more.removed, less.confirmed + less.removed - 1e-12);
    EXPECT_LT(more.appeared, less.appeared + 1e-12);
  });
}

TEST_F(ChangeProperties, EvidenceMovesLogOddsByJustAsMuch) {
  ForAll([](const Case& c) {
    const auto odds = [&](double former, double now) {
      const StatusPosterior p = ChangeStatus({.former = former, .now = now}, c.priors);
      return std::vector<double>{std::log(p.confirmed / p.removed),
                                 std::log(p.confirmed / p.appeared),
                                 std::log(p.appeared / p.nothing)};
    };
    const std::vector<double> at = odds(c.former, c.now), later = odds(c.former, c.now + 1.0),
                              earlier = odds(c.former + 1.0, c.now);
    EXPECT_NEAR(later[0] - at[0], 1.0, 1e-9) << "there or gone: this session tells";
    EXPECT_NEAR(later[1] - at[1], 0.0, 1e-9) << "known or new: the former one does";
    EXPECT_NEAR(later[2] - at[2], 1.0, 1e-9);
    EXPECT_NEAR(earlier[0] - at[0], 0.0, 1e-9);
    EXPECT_NEAR(earlier[1] - at[1], 1.0, 1e-9);
  });
}

TEST_F(ChangeProperties, WithoutAFormerSessionItIsADiscovery) {
  // An object that appears where none survives nor was: presence then is the prior of appearance.
  ForAll([](const Case& c) {
    StatusPriors none_before = c.priors;
    none_before.presence = 1e-12;
    StatusPriors as_new = c.priors;
    as_new.presence = c.priors.appearance;
    EXPECT_NEAR(ChangeStatus({.former = 0.0, .now = c.now}, none_before).appeared,
                DiscoveryStatus(c.now, as_new).appeared, 1e-9);
  });
}

TEST_F(ChangeProperties, SessionsCountAlikeWhereAppearingIsAsLikelyAsGoing) {
  // With as many objects before as after, time may run backwards: removed and new change places.
  ForAll([](const Case& c) {
    StatusPriors balanced = c.priors;
    balanced.appearance = c.priors.presence * (1.0 - c.priors.survival) / (1.0 - c.priors.presence);
    const StatusPosterior ahead = ChangeStatus({.former = c.former, .now = c.now}, balanced);
    const StatusPosterior back = ChangeStatus({.former = c.now, .now = c.former}, balanced);
    EXPECT_NEAR(ahead.confirmed, back.confirmed, 1e-12);
    EXPECT_NEAR(ahead.removed, back.appeared, 1e-12);
    EXPECT_NEAR(ahead.nothing, back.nothing, 1e-12);
  });
}

TEST_F(ChangeProperties, TheEntropyIsThatOfTheFourAndAtMostThatOfEqualChances) {
  ForAll([](const Case& c) {
    const StatusPosterior p = ChangeStatus({.former = c.former, .now = c.now}, c.priors);
    double entropy = 0.0;
    for (const double share : {p.confirmed, p.removed, p.appeared, p.nothing})
      entropy -= share > 0.0 ? share * std::log(share) : 0.0;
    EXPECT_NEAR(p.Entropy(), entropy, 1e-12);
    EXPECT_GE(p.Entropy(), 0.0);
    EXPECT_LE(p.Entropy(), std::log(4.0) + 1e-12);
  });
}

TEST_F(ChangeProperties, ADecisionIsTheStatusThatReachesTheThresholdAndNoOther) {
  ForAll([](const Case& c) {
    const StatusPosterior p = ChangeStatus({.former = c.former, .now = c.now}, c.priors);
    const Status expected = p.confirmed >= 0.9  ? Status::kConfirmed
                            : p.removed >= 0.9  ? Status::kRemoved
                            : p.appeared >= 0.9 ? Status::kNew
                            : p.nothing >= 0.9  ? Status::kNothing
                                                : Status::kUncertain;
    EXPECT_EQ(Decide(p, 3, c.priors), expected);
    EXPECT_EQ(Decide(p, 0, c.priors), Status::kNotInspected);
  });
}

}  // namespace
}  // namespace limpet
