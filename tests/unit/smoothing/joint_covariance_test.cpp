// SPDX-License-Identifier: MIT
// The incremental smoother against one dense inverse of the whole graph, for random graphs with
// everything that a graph may hold.
#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "tests/unit/smoothing/random_graph.hpp"

namespace limpet {
namespace {

class RandomGraphTest : public ::testing::TestWithParam<int> {
 protected:
  /// So many poses with all kinds of terms, updated as they come.
  void Build(int poses, bool updates = true) {
    for (int i = 0; i < poses; ++i) {
      graph_.AddPose();
      for (std::uint64_t k = graph_.random().Index(3); k > 0; --k)
        looks_.push_back(graph_.See());
      if (!graph_.slots.empty() && graph_.random().Chance(0.1)) graph_.AddPrior();
      if (graph_.random().Chance(0.05)) graph_.AddPair();
      if (updates && graph_.random().Chance(0.7)) smoother_.Update();
    }
    if (graph_.slots.empty()) looks_.push_back(graph_.See());
  }
  void ExpectExact() {
    const SolveReport report = smoother_.Converge();
    EXPECT_TRUE(report.has_converged) << report.reason;
    const WholeGraph whole(smoother_.graph());
    EXPECT_LT(whole.StepLeft(), 1e-3) << "not at the optimum";
    const Eigen::MatrixXd all = whole.Covariance();
    std::vector<int> nodes;
    std::vector<Eigen::Index> rows;
    const int count = smoother_.graph().node_count();
    for (const int node : {count - 1, 0, count / 2, count / 3}) {
      nodes.push_back(node);
      for (Eigen::Index k = 0; k < 6; ++k)
        rows.push_back(6 * node + k);
    }
    for (const int slot : graph_.slots) {
      for (Eigen::Index k = 0; k < 3; ++k)
        rows.push_back(whole.RowOf(slot) + k);
    }
    const Eigen::MatrixXd expected = all(rows, rows);
    const Eigen::VectorXd sd = expected.diagonal().cwiseSqrt();
    const Eigen::MatrixXd joint = smoother_.CovarianceOf(nodes, graph_.slots);
    EXPECT_LT((joint - expected).cwiseQuotient(sd * sd.transpose()).lpNorm<Eigen::Infinity>(),
              1e-5);
    const std::vector<NavCovariance> alone = smoother_.PoseCovariances();
    ASSERT_EQ(alone.size(), static_cast<std::size_t>(count));
    for (int node = 0; node < count; ++node) {
      const NavCovariance one = all.block<6, 6>(6 * node, 6 * node);
      const NavVector scale = one.diagonal().cwiseSqrt();
      EXPECT_LT((alone[static_cast<std::size_t>(node)] - one)
                    .cwiseQuotient(scale * scale.transpose())
                    .lpNorm<Eigen::Infinity>(),
                1e-5)
          << node;
    }
  }

  ArrowSmoother smoother_;
  RandomGraph graph_{static_cast<std::uint64_t>(GetParam()), smoother_};
  std::vector<TermId> looks_;
};

TEST_P(RandomGraphTest, CovariancesAreThoseOfTheWholeGraph) {
  Build(10 + 7 * GetParam());
  ExpectExact();
}

TEST_P(RandomGraphTest, AlsoWithWhatIsKnownOfSeveralLandmarksTogether) {
  Build(20 + 5 * GetParam());
  graph_.AddJointPrior();
  ExpectExact();
}

TEST_P(RandomGraphTest, AlsoAfterALandmarkIsRemovedAndItsSlotUsedAgain) {
  Build(40);
  graph_.AddJointPrior();
  graph_.RemoveLandmark();
  Build(20);
  ExpectExact();
}

TEST_P(RandomGraphTest, AlsoAfterEveryThirdLookIsTakenOut) {
  Build(60);
  for (std::size_t i = 0; i < looks_.size(); i += 3)
    smoother_.RemoveTerm(looks_[i]);
  for (const int slot : graph_.slots) {  // else one of them may be seen no more
    smoother_.AddBorderTerm(
        slot, Term::OnBorder(
                  BorderPriorFactor(Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()), slot));
  }
  ExpectExact();
}

TEST_P(RandomGraphTest, HeadAndBorderAreAsAnyVariablesAre) {
  Build(30 + GetParam());
  smoother_.Converge();
  const int head = smoother_.graph().node_count() - 1;
  const Eigen::MatrixXd at_hand = smoother_.Covariance(graph_.slots);
  const Eigen::MatrixXd asked = smoother_.CovarianceOf({head}, graph_.slots);
  EXPECT_LT((at_hand - asked).lpNorm<Eigen::Infinity>(), 1e-8);
}

TEST_P(RandomGraphTest, EveryCovarianceIsSymmetricAndPositive) {
  Build(50);  // as of the last update, not converged
  smoother_.Update();
  const Eigen::MatrixXd joint = smoother_.CovarianceOf({0, 20, 49}, graph_.slots);
  EXPECT_LT((joint - joint.transpose()).lpNorm<Eigen::Infinity>(), 1e-9);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(joint).eigenvalues().minCoeff(), -1e-9);
}

TEST_P(RandomGraphTest, TheOrderOfTheQuestionIsTheOrderOfTheAnswer) {
  Build(40);
  smoother_.Converge();
  const Eigen::MatrixXd ahead = smoother_.CovarianceOf({3, 35}, {});
  const Eigen::MatrixXd back = smoother_.CovarianceOf({35, 3}, {});
  EXPECT_LT((ahead.topLeftCorner<6, 6>() - back.bottomRightCorner<6, 6>()).norm(), 1e-10);
  EXPECT_LT((ahead.topRightCorner<6, 6>() - back.bottomLeftCorner<6, 6>()).norm(), 1e-10);
}

TEST_P(RandomGraphTest, KnowingMoreNeverMakesAnyVariableLessCertain) {
  Build(40);
  smoother_.Converge();
  const Eigen::VectorXd before = smoother_.CovarianceOf({0, 20, 39}, graph_.slots).diagonal();
  graph_.AddPrior();
  graph_.AddJointPrior();
  smoother_.Converge();
  const Eigen::VectorXd after = smoother_.CovarianceOf({0, 20, 39}, graph_.slots).diagonal();
  // Linearised a little elsewhere: a share of a percent.
  EXPECT_LT((after - 1.01 * before).maxCoeff(), 1e-9);
}

TEST_P(RandomGraphTest, UpdatedAsItGrowsOrSolvedAtOnceItIsOneOptimum) {
  Build(50);
  ArrowSmoother at_once;
  RandomGraph same(static_cast<std::uint64_t>(GetParam()), at_once);
  for (int i = 0; i < 50; ++i) {  // the same draws as Build's
    same.AddPose();
    for (std::uint64_t k = same.random().Index(3); k > 0; --k)
      static_cast<void>(same.See());
    if (!same.slots.empty() && same.random().Chance(0.1)) same.AddPrior();
    if (same.random().Chance(0.05)) same.AddPair();
    static_cast<void>(same.random().Chance(0.7));
  }
  if (same.slots.empty()) static_cast<void>(same.See());
  smoother_.Converge();
  at_once.Converge();
  ASSERT_EQ(same.slots, graph_.slots);
  for (int node = 0; node < 50; ++node)
    EXPECT_LT((smoother_.PoseAt(node) - at_once.PoseAt(node)).norm(), 1e-3) << node;
  for (const int slot : graph_.slots)
    EXPECT_LT((smoother_.BorderAt(slot) - at_once.BorderAt(slot)).norm(), 1e-3) << slot;
}

TEST_P(RandomGraphTest, ALookThatIsTakenOutAgainLeavesNoTrace) {
  Build(45);
  smoother_.Converge();
  std::vector<NavVector> before;
  for (int node = 0; node < 45; ++node)
    before.push_back(smoother_.PoseAt(node));
  const TermId wrong = smoother_.AddTerm(
      20, Term::OnObservation(BirthplaceFactor({9.0, 9.0, 9.0}, Meters(0.1)), graph_.slots[0]));
  smoother_.Converge();
  EXPECT_GT((smoother_.PoseAt(20) - before[20]).norm(), 0.01) << "else it had no effect";
  smoother_.RemoveTerm(wrong);
  smoother_.Converge();
  for (int node = 0; node < 45; ++node)
    EXPECT_LT((smoother_.PoseAt(node) - before[static_cast<std::size_t>(node)]).norm(), 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomGraphTest, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet
