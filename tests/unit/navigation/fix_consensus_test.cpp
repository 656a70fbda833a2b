// SPDX-License-Identifier: MIT
#include "estimation/navigation/fix_consensus.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

using namespace literals;

constexpr double kSd = 0.5;  // [m]
const FixError kStated{.sd = kSd, .correlation = 120.0_s};
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

/// Errors of a stay's fixes: white ones, and some that stay alike for about two minutes.
std::vector<Eigen::Vector2d> Errors(double white, double slow, Random& random) {
  const double keep = std::exp(-1.0 / 120.0), change = slow * std::sqrt(1.0 - keep * keep);
  Eigen::Vector2d wander(random.Normal(slow), random.Normal(slow));
  std::vector<Eigen::Vector2d> errors;
  for (int i = 0; i < 45; ++i) {
    wander = keep * wander + Eigen::Vector2d(random.Normal(change), random.Normal(change));
    errors.emplace_back(wander + Eigen::Vector2d(random.Normal(white), random.Normal(white)));
  }
  return errors;
}

TEST(SpreadScale, GrowsWhereFixesWanderMoreThanTheyState) {
  Random random(3, "fixes");
  double usual = 0.0, worse = 0.0;
  for (int i = 0; i < 200; ++i) {
    usual += SpreadScale(Errors(0.25, 0.4, random), 44.0_s, kStated) / 200.0;
    worse += SpreadScale(Errors(0.25, 1.6, random), 44.0_s, kStated) / 200.0;
  }
  EXPECT_LT(usual, 1.2);
  EXPECT_GT(worse, 1.8);
}

TEST(SpreadScale, LeavesOutWhatDiffersFromFixToFix) {
  Random random(4, "fixes");
  double scale = 0.0;  // of 0.4 m that wander and 0.3 m that do not: 0.5 m in all
  for (int i = 0; i < 200; ++i)
    scale += SpreadScale(Errors(0.3, 0.4, random), 44.0_s, kStated) / 200.0;
  EXPECT_LT(scale, 1.0);
  EXPECT_GT(scale, 0.75);
}

TEST(SpreadScale, FewFixesSayNothing) {
  EXPECT_EQ(SpreadScale({{0.0, 0.0}, {9.0, 9.0}}, 1.0_s, kStated), 1.0);
}

}  // namespace
}  // namespace limpet
