// SPDX-License-Identifier: MIT
#include "estimation/navigation/fix_consensus.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kSd = 0.5;  // [m]
const FixPrediction kHere{.off_W = Eigen::Vector2d::Zero(),
                          .covariance_W = 0.04 * Eigen::Matrix2d::Identity()};

class FixConsensusTest : public ::testing::Test {
 protected:
  /// A fix a second, so far from where dead reckoning has them; how many were believed.
  int Give(double seconds, const Eigen::Vector2d& off_W) {
    int believed = 0;
    for (const double end = t_ + seconds; t_ < end; t_ += 1.0) {
      last_ = consensus_.Add({.fix = {.t = t_, .p_W = off_W, .sd = kSd}, .off_W = off_W});
      believed += last_.is_believed ? 1 : 0;
    }
    return believed;
  }
  FixConsensus consensus_;
  FixConsensus::Verdict last_;
  double t_ = 100.0;
};

TEST_F(FixConsensusTest, FixesThatLieAlikeAreAllBelieved) {
  consensus_.BeginStay(kHere);
  EXPECT_EQ(Give(20.0, {0.5, -0.5}), 20);
  EXPECT_EQ(consensus_.refused(), 0U);
}

TEST_F(FixConsensusTest, JumpsAreNotBelieved) {
  consensus_.BeginStay(kHere);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(Give(15.0, {0.2, 0.0}), 15);
    EXPECT_EQ(Give(12.0, {8.0 + 5.0 * i, -3.0}), 0);
  }
  EXPECT_EQ(consensus_.refused(), 36U);
  EXPECT_EQ(consensus_.believed().size(), 45U);
  EXPECT_LT(consensus_.DoubtVariance(), 0.01);
}

TEST_F(FixConsensusTest, WhereTwoPlacesAreAboutAsLikelyTheDoubtIsAsLargeAsTheirDistance) {
  consensus_.BeginStay(std::nullopt);
  Give(20.0, {0.0, 0.0});
  EXPECT_EQ(consensus_.DoubtVariance(), 0.0);
  Give(18.0, {8.0, 0.0});
  EXPECT_GT(consensus_.DoubtVariance(), 8.0);
  Give(10.0, {0.0, 0.0});
  EXPECT_LT(consensus_.DoubtVariance(), 1.0) << "fixes came back";
}

TEST_F(FixConsensusTest, AStayThatBeginsInAJumpIsPutRightByItsMajority) {
  consensus_.BeginStay(std::nullopt);
  EXPECT_EQ(Give(8.0, {8.0, -3.0}), 8) << "nothing says otherwise yet";
  EXPECT_LT(Give(20.0, {0.0, 0.0}), 20);
  EXPECT_TRUE(last_.is_believed);
  EXPECT_EQ(consensus_.believed().size(), 20U) << "those that were not believed at first, too";
  EXPECT_EQ(consensus_.refused(), 8U);
}

TEST_F(FixConsensusTest, AgainstThePredictionFixesAreBelievedOnceTheySpanTimeEnough) {
  consensus_.BeginStay(kHere);
  EXPECT_EQ(Give(20.0, {8.0, 0.0}), 0);
  EXPECT_GT(Give(5.0, {8.0, 0.0}), 0) << "dead reckoning is what is wrong";
}

TEST_F(FixConsensusTest, ManyFixesOfOneMomentDoNotSpanTime) {
  consensus_.BeginStay(kHere);
  for (int i = 0; i < 100; ++i) {
    t_ += 0.1;
    EXPECT_FALSE(
        consensus_.Add({.fix = {.t = t_, .p_W = {8.0, 0.0}, .sd = kSd}, .off_W = {8.0, 0.0}})
            .is_believed);
  }
}

TEST_F(FixConsensusTest, AStayEndsWhenNoFixHasComeForLong) {
  EXPECT_TRUE(consensus_.IsNewStay(t_));
  consensus_.BeginStay(kHere);
  Give(5.0, {0.0, 0.0});
  EXPECT_FALSE(consensus_.IsNewStay(t_ + 30.0));
  EXPECT_TRUE(consensus_.IsNewStay(t_ + 100.0));
}

/// How many fixes of `seconds` whose error wanders by this sigma, for about two minutes, are one
/// group's, and how many are refused.
std::pair<int, int> Wandering(double sigma, double seconds, std::uint64_t seed) {
  Random random(seed, "fixes");
  FixConsensus consensus;
  consensus.BeginStay(std::nullopt);
  const double keep = std::exp(-1.0 / 120.0), change = sigma * std::sqrt(1.0 - keep * keep);
  Eigen::Vector2d off(random.Normal(sigma), random.Normal(sigma));
  for (double t = 0.0; t < seconds; t += 1.0) {
    off = keep * off + Eigen::Vector2d(random.Normal(change), random.Normal(change));
    consensus.Add({.fix = {.t = t, .p_W = off, .sd = 0.4}, .off_W = off});
  }
  return {static_cast<int>(consensus.believed().size()), static_cast<int>(consensus.refused())};
}

TEST(FixConsensus, FixesThatWanderFiveTimesAsFarAsTheyStateAreNoJumps) {
  int believed = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto [taken, left] = Wandering(2.0, 300.0, seed);
    believed += taken, refused += left;
  }
  EXPECT_LT(refused, believed / 100);
}

}  // namespace
}  // namespace limpet
