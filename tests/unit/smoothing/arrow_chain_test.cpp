// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_chain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/batch_solver.hpp"
#include "tests/unit/smoothing/random_graph.hpp"

namespace limpet {
namespace {

constexpr int kLane = 100;  // poses, half a metre apart

/// A vehicle goes up and down a lane with an object every five metres, of which it sees those
/// within three.
class ArrowChainTest : public ::testing::Test {
 protected:
  void Drive(int poses) {
    for (int i = 0; i < poses; ++i) {
      AddPose();
      Look();
      smoother_.Update();
    }
  }
  void AddPose() {
    const int node = smoother_.graph().node_count();
    if (node == 0) {
      smoother_.AddNode(truth_, std::nullopt);
      smoother_.AddTerm(0, Term::OnPose(PosePriorFactor(truth_, NavVector::Constant(0.1))));
    } else {
      const bool turns = node % kLane == 0;
      const double way = (node / kLane) % 2 == 0 ? 0.5 : -0.5;
      const Eigen::Vector4d variance(1e-3, 1e-3, 1e-4, 1e-5);
      Eigen::Vector4d motion(turns ? 0.0 : way, 0.0, 0.0, 0.0);
      truth_.head<2>() += motion.head<2>();
      for (int i = 0; i < 4; ++i)
        motion(i) += random_.Normal(std::sqrt(variance(i)));
      NavVector guess = smoother_.PoseAt(node - 1);
      guess.head<2>() += motion.head<2>();
      smoother_.AddNode(guess, Term::OnStep(XyzYawFactor(motion, variance)));
    }
    smoother_.AddTerm(node, Term::OnPose(DepthFactor(Meters(0.0), Meters(0.05))));
    smoother_.AddTerm(node,
                      Term::OnPose(RollPitchFactor(Radians(0.0), Radians(0.0), Radians(0.02))));
  }
  void Look() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Eigen::Vector3d off = places_[i] - truth_.head<3>();
      if (off.head<2>().norm() > 3.0) continue;
      if (slots_[i] < 0) slots_[i] = smoother_.AddLandmark(places_[i]);
      const Eigen::Vector3d seen = off + Eigen::Vector3d(random_.Normal(0.1), 0.0, 0.0);
      smoother_.AddTerm(smoother_.graph().node_count() - 1,
                        Term::OnObservation(BirthplaceFactor(seen, Meters(0.3)), slots_[i]));
    }
  }
  [[nodiscard]] std::ptrdiff_t CountResting() const {
    return std::ranges::count_if(slots_,
                                 [&](int slot) { return slot >= 0 && !smoother_.IsAtHand(slot); });
  }
  [[nodiscard]] double WorstDifferenceToBatch() const {
    ChainGraph graph = smoother_.graph();
    EXPECT_TRUE(SolveBatch(graph).has_converged);
    double worst = 0.0;
    for (int i = 0; i < graph.node_count(); ++i)
      worst = std::max(worst, (smoother_.PoseAt(i) - graph.node(i).x).lpNorm<Eigen::Infinity>());
    for (const int slot : slots_) {
      if (slot < 0) continue;
      worst = std::max(worst, (smoother_.BorderAt(slot) - graph.border(slot).x).norm());
    }
    return worst;
  }

  Random random_{3, "lane"};
  NavVector truth_ = NavVector::Zero();
  const std::vector<Eigen::Vector3d> places_{{2, 1, 3},  {7, -1, 3},  {12, 1, 3}, {17, -1, 3},
                                             {22, 1, 3}, {27, -1, 3}, {32, 1, 3}, {37, -1, 3},
                                             {42, 1, 3}, {47, -1, 3}};
  std::vector<int> slots_ = std::vector<int>(places_.size(), -1);
  ArrowSmoother smoother_{{.most_at_hand = 3}};
};

TEST_F(ArrowChainTest, ObjectsFarBehindAreNotSolvedWithTheNewestPose) {
  Drive(kLane);
  EXPECT_GE(CountResting(), 5);
  EXPECT_LE(smoother_.border_size(), 5);
  EXPECT_LT(WorstDifferenceToBatch(), 5e-3);
}

TEST_F(ArrowChainTest, RestingObjectsSeenAgainCorrectTheTrackAsIfTheyHadNeverRested) {
  for (int lane = 0; lane < 4; ++lane) {
    Drive(kLane - 7);
    EXPECT_GT(CountResting(), 0);
    EXPECT_LT(WorstDifferenceToBatch(), 5e-3) << "in lane " << lane;
  }
  EXPECT_TRUE(smoother_.Converge().has_converged);
  EXPECT_LT(WorstDifferenceToBatch(), 1e-4);
}

TEST_F(ArrowChainTest, CovariancesOfObjectsFarAwayAreThoseOfTheWholeGraph) {
  Drive(kLane + 20);
  smoother_.Converge();
  ASSERT_GT(CountResting(), 3);
  const WholeGraph whole(smoother_.graph());
  const Eigen::MatrixXd all = whole.Covariance();
  const Eigen::Index pose = 6 * (smoother_.graph().node_count() - 1);
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < 6; ++i)
    rows.push_back(pose + i);
  for (const int slot : slots_) {
    for (Eigen::Index i = 0; i < 3; ++i)
      rows.push_back(whole.RowOf(slot) + i);
  }
  const Eigen::MatrixXd expected = all(rows, rows);
  EXPECT_LT((smoother_.Covariance(slots_) - expected).norm(), 1e-6 * expected.norm());
  const std::vector<Eigen::Matrix3d> alone = smoother_.BorderCovariances(slots_);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(6 + 3 * i);
    EXPECT_LT((alone[i] - expected.block<3, 3>(row, row)).norm(), 1e-6 * alone[i].norm()) << i;
  }
}

TEST_F(ArrowChainTest, RestingObjectsAreAtHandWithTheNextLeafWhenTheyAreNeeded) {
  Drive(kLane);
  ASSERT_FALSE(smoother_.IsAtHand(slots_[0]));
  for (int i = 0; i < ArrowLeaf::kNodes; ++i) {
    smoother_.KeepAtHand({slots_[0]});
    Drive(1);
  }
  EXPECT_TRUE(smoother_.IsAtHand(slots_[0]));
  EXPECT_FALSE(smoother_.IsAtHand(slots_[1]));
  EXPECT_LT(WorstDifferenceToBatch(), 5e-3);
}

TEST_F(ArrowChainTest, RestingObjectsCanBeRemovedOrHeldElsewhere) {
  Drive(kLane + 50);
  ASSERT_FALSE(smoother_.IsAtHand(slots_[1]));
  ASSERT_FALSE(smoother_.IsAtHand(slots_[2]));
  smoother_.RemoveLandmark(slots_[1]);
  slots_[1] = -1;
  const Eigen::Vector3d pair = smoother_.BorderAt(slots_[2]);
  smoother_.AddBorderTerm(
      slots_[2],
      Term::OnBorder(BorderPriorFactor(pair, 1e-4 * Eigen::Matrix3d::Identity()), slots_[2]));
  while (!smoother_.Update().has_converged) {
  }
  EXPECT_LT(WorstDifferenceToBatch(), 5e-3);
  Drive(60);
  smoother_.Converge();
  EXPECT_LT(WorstDifferenceToBatch(), 1e-4);
}

TEST_F(ArrowChainTest, AWrongLookTakenOutFarBackIsForgottenWhereItRests) {
  Drive(20);
  const TermId wrong = smoother_.AddTerm(
      6, Term::OnObservation(BirthplaceFactor(Eigen::Vector3d(3, 3, 3), Meters(0.3)), slots_[0]));
  Drive(kLane - 20);
  ASSERT_FALSE(smoother_.IsAtHand(slots_[0]));
  smoother_.RemoveTerm(wrong);
  while (!smoother_.Update().has_converged) {
  }
  EXPECT_LT(WorstDifferenceToBatch(), 5e-3);
}

}  // namespace
}  // namespace limpet
