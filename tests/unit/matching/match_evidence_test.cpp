// SPDX-License-Identifier: MIT
// How much likelier a match makes what is seen, over random fields.
#include "estimation/matching/match_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

class MatchEvidenceProperties : public ::testing::TestWithParam<int> {
 protected:
  MatchEvidenceProperties() {
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d p_W(random_.Uniform(-20.0, 20.0), random_.Uniform(-20.0, 20.0), 6.0);
      ObjectEstimate object{
          .p_W = p_W, .cov_W = 0.01 * Eigen::Matrix3d::Identity(), .color = "yellow"};
      former_.push_back(object);
      object.p_W += Eigen::Vector3d(random_.Normal(0.1), random_.Normal(0.1), 0.0);
      now_.push_back(object);
    }
  }
  [[nodiscard]] SessionMatch Matched(int count) const {
    FormerMatches now_of_former(former_.size());
    for (int i = 0; i < count; ++i)
      now_of_former[static_cast<std::size_t>(i)] = i;
    return FitSessions(former_, now_, now_of_former, params_);
  }
  [[nodiscard]] double EvidenceOf(const SessionMatch& match) const {
    return MatchEvidence(former_, now_, match, params_, FramePrior::Known(OffsetPrior(params_)));
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "evidence"};
  std::vector<ObjectEstimate> former_, now_;
  const MatchingParams params_{};
};

TEST_P(MatchEvidenceProperties, NoMatchIsNoEvidence) {
  EXPECT_NEAR(EvidenceOf(Matched(0)), 0.0, 0.05);
}

TEST_P(MatchEvidenceProperties, EveryTrueMatchAddsSome) {
  double before = EvidenceOf(Matched(0));
  for (int count = 1; count <= 8; ++count) {
    const double now = EvidenceOf(Matched(count));
    EXPECT_GT(now, before + 1.0) << count;
    before = now;
  }
}

TEST_P(MatchEvidenceProperties, AWrongPairCostsMoreThanItBrings) {
  SessionMatch match = Matched(6);
  const double without = EvidenceOf(match);
  // Of those that are left the one farthest from where it should be.
  const auto farther = [this](const ObjectEstimate& a, const ObjectEstimate& b) {
    return (former_[6].p_W - a.p_W).norm() < (former_[6].p_W - b.p_W).norm();
  };
  const auto wrong = std::max_element(now_.begin() + 7, now_.end(), farther);
  ASSERT_GT((former_[6].p_W - wrong->p_W).norm(), 2.0);
  match.now_of_former[6] = static_cast<int>(wrong - now_.begin());
  EXPECT_LT(EvidenceOf(match), without);
}

TEST_P(MatchEvidenceProperties, DoesNotDependOnWhereTheOriginIs) {
  const double here = EvidenceOf(Matched(8));
  const Eigen::Vector3d shift_W(random_.Normal(100.0), random_.Normal(100.0), 0.0);
  for (ObjectEstimate& object : former_)
    object.p_W += shift_W;
  for (ObjectEstimate& object : now_)
    object.p_W += shift_W;
  EXPECT_NEAR(EvidenceOf(Matched(8)), here, 1e-6);
}

TEST_P(MatchEvidenceProperties, AFrameKnownBetterMakesATrueMatchLikelier) {
  const SessionMatch match = Matched(8);
  const double known = EvidenceOf(match);
  const double unknown =
      MatchEvidence(former_, now_, match, params_, FramePrior::Unknown(50.0, Radians(1.0)));
  EXPECT_GT(known, unknown);
}

INSTANTIATE_TEST_SUITE_P(Drawn, MatchEvidenceProperties, ::testing::Range(1, 9));

TEST(MatchEvidence, AMatchTellsMoreTheMoreRoomThereWasToLieElsewhere) {
  const auto object_at = [](double north, double east) {
    return ObjectEstimate{
        .p_W = {north, east, 6.0}, .cov_W = 0.01 * Eigen::Matrix3d::Identity(), .color = "yellow"};
  };
  const MatchingParams params;
  const auto evidence = [&](double north, double east) {
    const std::vector<ObjectEstimate> former{object_at(0.0, 0.0)};
    const std::vector<ObjectEstimate> now{object_at(0.0, 0.0), object_at(north, east)};
    return MatchEvidence(former, now, FitSessions(former, now, {0}, params), params,
                         FramePrior::Known(OffsetPrior(params)));
  };
  // Five metres around the outermost objects were seen, too.
  const double rooms = (30.0 + 10.0) * (20.0 + 10.0) / ((3.0 + 10.0) * (4.0 + 10.0));
  EXPECT_NEAR(evidence(30.0, 20.0) - evidence(3.0, 4.0), std::log(rooms), 1e-9);
}

TEST(FramePrior, OfAKnownFrameIsADensity) {
  MatchingParams params;
  params.offset_sigma = Meters(0.5);
  params.turn_sigma = Radians(0.05);
  const FramePrior prior = FramePrior::Known(OffsetPrior(params));
  // Summed over a fine grid of north and turn; east has the same sigma as north.
  double sum = 0.0;
  constexpr double kCell = 0.1, kTurn = 0.01;
  for (int i = -40; i <= 40; ++i) {
    for (int j = -40; j <= 40; ++j) {
      for (int k = -30; k <= 30; ++k) {
        FrameOffset offset;
        offset.shift_W = {kCell * i, kCell * j};
        offset.turn = kTurn * k;
        sum += std::exp(prior.LogDensity(offset)) * kCell * kCell * kTurn;
      }
    }
  }
  EXPECT_NEAR(sum, 1.0, 0.01);
}

TEST(FramePrior, OfAnUnknownFrameIsEvenOverItsNeighbourhood) {
  const FramePrior prior = FramePrior::Unknown(10.0, Radians(0.5));
  const double density = std::exp(prior.LogDensity({}));
  EXPECT_NEAR(density * std::numbers::pi * 100.0 * 1.0, 1.0, 1e-9);
  FrameOffset off;
  off.shift_W = {7.0, -5.0};
  off.turn = 0.4;
  EXPECT_EQ(prior.LogDensity(off), prior.LogDensity({}));
}

}  // namespace
}  // namespace limpet
