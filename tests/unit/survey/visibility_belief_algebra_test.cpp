// SPDX-License-Identifier: MIT
// What evidence does to the belief in the water, whatever the evidence is.
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {
namespace {

PerVisibility DrawEvidence(Random& random, double scale) {
  PerVisibility evidence;
  for (int i = 0; i < PerVisibility::kCount; ++i)
    evidence(i) = random.Normal(scale);
  return evidence;
}

VisibilityBelief DrawBelief(Random& random) {
  return {Meters(random.Uniform(0.8, 30.0)), random.Uniform(1.1, 3.0)};
}

class VisibilityBeliefAlgebra : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "visibility"};
};

TEST_P(VisibilityBeliefAlgebra, ChancesStayChances) {
  VisibilityBelief belief = DrawBelief(random_);
  for (int i = 0; i < 100; ++i) {
    belief.Add(DrawEvidence(random_, 20.0), random_.Uniform(0.1, 8.0));
    EXPECT_NEAR(belief.chances().sum(), 1.0, 1e-12);
    EXPECT_GE(belief.chances().minCoeff(), 0.0);
    EXPECT_TRUE(belief.chances().allFinite());
  }
}

TEST_P(VisibilityBeliefAlgebra, TheOrderOfEvidenceDoesNotMatter) {
  const VisibilityBelief start = DrawBelief(random_);
  const PerVisibility one = DrawEvidence(random_, 2.0), other = DrawEvidence(random_, 2.0);
  VisibilityBelief forth = start, back = start;
  forth.Add(one, 5.0), forth.Add(other, 3.0);
  back.Add(other, 3.0), back.Add(one, 5.0);
  EXPECT_TRUE(forth.chances().isApprox(back.chances(), 1e-12));
}

TEST_P(VisibilityBeliefAlgebra, AConstantIsNoEvidence) {
  VisibilityBelief with = DrawBelief(random_);
  VisibilityBelief without = with;
  const PerVisibility evidence = DrawEvidence(random_, 1.0);
  without.Add(evidence, 4.0);
  with.Add(evidence + random_.Normal(100.0), 4.0);
  EXPECT_TRUE(with.chances().isApprox(without.chances(), 1e-9));
}

TEST_P(VisibilityBeliefAlgebra, NoOddsChangeByMoreThanTheBound) {
  for (int run = 0; run < 20; ++run) {
    VisibilityBelief belief = DrawBelief(random_);
    const PerVisibility before = belief.chances();
    const double most = random_.Uniform(0.1, 6.0);
    belief.Add(DrawEvidence(random_, 30.0), most);
    const PerVisibility change = (belief.chances() / before).log();
    EXPECT_LE(change.maxCoeff() - change.minCoeff(), most + 1e-9);
  }
}

TEST_P(VisibilityBeliefAlgebra, WeakEvidenceIsTakenInFull) {
  VisibilityBelief belief = DrawBelief(random_);
  const PerVisibility before = belief.chances();
  const PerVisibility evidence = DrawEvidence(random_, 0.3);
  belief.Add(evidence, 50.0);
  const PerVisibility change = (belief.chances() / before).log() - evidence;
  EXPECT_LT(change.maxCoeff() - change.minCoeff(), 1e-9);
}

TEST_P(VisibilityBeliefAlgebra, NoVisibilityIsRuledOutBeforeTheDive) {
  const VisibilityBelief belief = DrawBelief(random_);
  EXPECT_GT(belief.chances().minCoeff(), 1e-4);
}

TEST_P(VisibilityBeliefAlgebra, EvidenceForOneVisibilityMovesTheEstimateThere) {
  const VisibilityBelief start = DrawBelief(random_);
  const auto at = static_cast<int>(random_.Index(PerVisibility::kCount));
  PerVisibility evidence = -8.0;
  evidence(at) = 0.0;
  VisibilityBelief belief = start;
  const double truth = std::log(VisibilityBelief::Grid()(at));
  const auto off = [truth](const VisibilityBelief& b) {
    return std::abs(std::log(b.estimate().visibility.value()) - truth);
  };
  for (int i = 0; i < 4; ++i)
    belief.Add(evidence, 8.0);
  EXPECT_LE(off(belief), off(start) + 1e-9);
  EXPECT_LT(off(belief), 0.01);
  // What remains is what the detector's visibility and the water's differ by.
  EXPECT_NEAR(belief.estimate().sd.value() / belief.estimate().visibility.value(),
              VisibilityBelief::kDetectorSpread, 0.02);
}

TEST_P(VisibilityBeliefAlgebra, ExpectationsAreLinear) {
  const VisibilityBelief belief = DrawBelief(random_);
  const PerVisibility a = DrawEvidence(random_, 1.0), b = DrawEvidence(random_, 1.0);
  EXPECT_NEAR(belief.Expect(2.0 * a - 3.0 * b), 2.0 * belief.Expect(a) - 3.0 * belief.Expect(b),
              1e-12);
  EXPECT_NEAR(belief.Expect(7.0), 7.0, 1e-12);
}

TEST(VisibilityGrid, IsSpacedEvenlyInTheLogarithmBetweenItsEnds) {
  const PerVisibility& grid = VisibilityBelief::Grid();
  EXPECT_NEAR(grid(0), VisibilityBelief::kLeast_m, 1e-12);
  EXPECT_NEAR(grid(PerVisibility::kCount - 1), VisibilityBelief::kMost_m, 1e-9);
  const double step = grid(1) / grid(0);
  for (int i = 1; i < PerVisibility::kCount; ++i)
    EXPECT_NEAR(grid(i) / grid(i - 1), step, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, VisibilityBeliefAlgebra, ::testing::Range(1, 13));

}  // namespace
}  // namespace limpet
