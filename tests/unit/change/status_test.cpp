// SPDX-License-Identifier: MIT
#include "estimation/change/status.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const StatusPriors kPriors;

TEST(ChangeStatus, SumsToOneForAnyEvidence) {
  for (double former = -800.0; former <= 800.0; former += 100.0) {
    for (double now = -800.0; now <= 800.0; now += 100.0) {
      const StatusPosterior p = ChangeStatus({.former = former, .now = now}, kPriors);
      EXPECT_NEAR(p.confirmed + p.removed + p.appeared + p.nothing, 1.0, 1e-12);
      EXPECT_TRUE(std::isfinite(p.Entropy()));
    }
  }
}

TEST(ChangeStatus, MatchesAHandComputedCase) {
  const StatusPriors priors{.presence = 0.2, .survival = 0.5, .appearance = 0.1, .decide_at = 0.9};
  const StatusPosterior p = ChangeStatus({.former = std::log(9.0), .now = std::log(0.1)}, priors);
  // C 0.2*0.5*0.9 = 0.09, R 0.2*0.5*9 = 0.9, N 0.8*0.1*0.1 = 0.008, nothing 0.8*0.9 = 0.72.
  EXPECT_NEAR(p.confirmed, 0.09 / 1.718, 1e-12);
  EXPECT_NEAR(p.removed, 0.9 / 1.718, 1e-12);
  EXPECT_NEAR(p.appeared, 0.008 / 1.718, 1e-12);
  EXPECT_NEAR(p.nothing, 0.72 / 1.718, 1e-12);
}

TEST(ChangeStatus, DecidesTheFourCases) {
  EXPECT_EQ(Decide(ChangeStatus({.former = 12, .now = 12}, kPriors), 5, kPriors),
            Status::kConfirmed);
  EXPECT_EQ(Decide(ChangeStatus({.former = 12, .now = -6}, kPriors), 5, kPriors), Status::kRemoved);
  EXPECT_EQ(Decide(ChangeStatus({.former = -6, .now = 12}, kPriors), 5, kPriors), Status::kNew);
  EXPECT_EQ(Decide(ChangeStatus({.former = -6, .now = -6}, kPriors), 5, kPriors), Status::kNothing);
}

TEST(ChangeStatus, IsNotInspectedWithoutALook) {
  StatusPriors sure_to_stay = kPriors;
  sure_to_stay.survival = 0.99;
  EXPECT_EQ(Decide(ChangeStatus({.former = 12, .now = 0}, sure_to_stay), 0, sure_to_stay),
            Status::kNotInspected);
}

TEST(ChangeStatus, TwoCleanPassesSayNinetyNinePercent) {
  // 8.5 and -3.9 are what one clean pass gives with a good detector (LookLog).
  EXPECT_GT(ChangeStatus({.former = 17.0, .now = 17.0}, kPriors).confirmed, 0.99);
  EXPECT_GT(ChangeStatus({.former = 17.0, .now = -7.8}, kPriors).removed, 0.99);
  EXPECT_GT(ChangeStatus({.former = -7.8, .now = 17.0}, kPriors).appeared, 0.99);
}

/// A stone that looks like a buoy looks like one in both sessions.
TEST(ChangeStatus, BoxesOfBothSessionsAreNotTwiceAsSureThatItIsAnObject) {
  const VisibilityBelief water(Meters(8.0), 2.0);
  const double surest = -std::log(0.5 * kPriors.lookalike);
  const PlaceEvidence now{.present = 40.0, .lookalike = 40.0 - std::log(2.0)};
  const StatusPosterior lasting = ChangeStatus(surest, now, water, kPriors);
  EXPECT_GT(lasting.confirmed, 0.995);
  EXPECT_GT(lasting.nothing, 2e-4);
  StatusPriors passing = kPriors;
  passing.lookalike_survival = 0.0;
  EXPECT_LT(ChangeStatus(surest, now, water, passing).nothing, 1e-6);
  StatusPriors common = kPriors;
  common.lookalike = 0.02;
  EXPECT_LT(ChangeStatus(-std::log(0.5 * common.lookalike), now, water, common).confirmed, 0.9);
}

TEST(ChangeStatus, IsMostUncertainBeforeALook) {
  const double before = ChangeStatus({.former = 12, .now = 0}, kPriors).Entropy();
  EXPECT_GT(before, ChangeStatus({.former = 12, .now = 5}, kPriors).Entropy());
  EXPECT_GT(before, ChangeStatus({.former = 12, .now = -5}, kPriors).Entropy());
}

TEST(DiscoveryStatus, WeighsOnlyPresence) {
  const StatusPosterior p = DiscoveryStatus(8.5, kPriors);
  EXPECT_EQ(p.confirmed + p.removed, 0.0);
  EXPECT_NEAR(p.appeared, 0.02 * std::exp(8.5) / (0.02 * std::exp(8.5) + 0.98), 1e-12);
  EXPECT_EQ(Decide(p, 5, kPriors), Status::kNew);
}

}  // namespace
}  // namespace limpet
