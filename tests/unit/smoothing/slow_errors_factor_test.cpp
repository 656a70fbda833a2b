// SPDX-License-Identifier: MIT
// Blocks of slow errors that are closed: they leave the border, and are estimated all the same.
#include "estimation/smoothing/factors/slow_errors_factor.hpp"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/calibrated_step_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "tests/support/batch_solver.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

/// A straight way with a slow error of the steps that changes from stretch to stretch, as do the
/// blocks that stand for it; each is closed when the next one begins.
class SlowErrorsTest : public ::testing::Test {
 protected:
  static constexpr int kStretch = 40;  // steps
  void DriveStraight(int steps, bool closes) {
    for (int i = 0; i < steps; ++i) {
      const int k = smoother_->graph().node_count();
      const NavVector at = (NavVector() << 0.5 * k, 0.0, 0.0, 0.0, 0.0, 0.0).finished();
      if (k % kStretch == 0) Change(closes);
      if (k == 0) {
        smoother_->AddNode(at, std::nullopt);
      } else {
        const double scale = 0.01 * (k / kStretch + 1);
        const Eigen::Vector4d variance(1e-4, 1e-4, 1e-4, 1e-6);
        const CalibratedStepFactor step({0.5 * (1.0 + scale), 0.0, 0.0, 0.0}, variance, 1.0);
        smoother_->AddNode(at, Term::OnStep(step, std::array{blocks_.back()}));
      }
      const NavVector sigma = NavVector::Constant(0.05);
      if (k % 5 == 0) smoother_->AddTerm(k, Term::OnPose(PosePriorFactor(at, sigma)));
      smoother_->Update();
    }
  }
  void Change(bool closes) {
    const int next = smoother_->AddSensorErrors(Eigen::Vector3d::Zero());
    if (blocks_.empty()) {
      const BorderPriorFactor prior(Eigen::Vector3d::Zero(), 4e-4 * Eigen::Matrix3d::Identity());
      smoother_->AddBorderTerm(next, Term::OnBorder(prior, next));
    } else {
      const SlowErrorsFactor change({1.0, 0.9, 0.9}, Eigen::Vector3d::Constant(0.02));
      smoother_->AddBorderTerm(blocks_.back(),
                               Term::OnBorder(change, std::array{blocks_.back(), next}));
      if (closes) smoother_->CloseSensorErrors(blocks_.back());
    }
    blocks_.push_back(next);
  }
  std::optional<ArrowSmoother> smoother_{std::in_place};
  std::vector<int> blocks_;
};

TEST_F(SlowErrorsTest, ErrorsThatAreClosedAreEstimatedAllTheSame) {
  DriveStraight(450, true);
  ChainGraph graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    EXPECT_GT(smoother_->BorderAt(blocks_[i]).x(), 0.005 * static_cast<double>(i + 1));
    EXPECT_LT((smoother_->BorderAt(blocks_[i]) - graph.border(blocks_[i]).x).norm(), 1e-5);
  }
  for (const int node : {0, 17, 130, 255, 256, 300, 449})
    EXPECT_LT((smoother_->PoseAt(node) - graph.node(node).x).norm(), 1e-4) << node;
}

TEST_F(SlowErrorsTest, ErrorsThatAreClosedMayStillBeLinearisedAnew) {
  DriveStraight(450, true);
  const NavVector off = (NavVector() << 25.2, 0.0, 0.0, 0.0, 0.0, 0.0).finished();
  const TermId id =
      smoother_->AddTerm(50, Term::OnPose(PosePriorFactor(off, NavVector::Constant(0.01))));
  while (!smoother_->Update().has_converged) {
  }
  ChainGraph graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT((smoother_->BorderAt(blocks_[1]) - graph.border(blocks_[1]).x).norm(), 1e-4);
  EXPECT_LT((smoother_->PoseAt(50) - graph.node(50).x).norm(), 1e-3);
  smoother_->RemoveTerm(id);
  EXPECT_TRUE(smoother_->Converge().has_converged);
  graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT((smoother_->BorderAt(blocks_[1]) - graph.border(blocks_[1]).x).norm(), 1e-6);
}

TEST_F(SlowErrorsTest, CovariancesAreTheSameWhetherErrorsAreClosedOrNot) {
  DriveStraight(330, true);
  const std::vector<int> nodes{329, 20, 161, 48}, blocks{blocks_[0], blocks_.back(), blocks_[3]};
  const Eigen::MatrixXd closed = smoother_->CovarianceOf(nodes, blocks);
  smoother_.emplace();
  blocks_.clear();
  DriveStraight(330, false);
  const Eigen::MatrixXd open = smoother_->CovarianceOf(nodes, blocks);
  EXPECT_LT((closed - open).norm(), 1e-4 * open.norm());
  EXPECT_LT(
      (closed - open)
          .cwiseQuotient(open.diagonal().cwiseSqrt() * open.diagonal().cwiseSqrt().transpose())
          .lpNorm<Eigen::Infinity>(),
      1e-3);
}

TEST_F(SlowErrorsTest, AnUpdateStaysAsCheapHoweverManyErrorsAreClosed) {
  DriveStraight(450, true);
  EXPECT_LE(smoother_->border_size(), 2);
}

TEST(SlowErrorsFactor, IsZeroWhenTheErrorsFade) {
  const SlowErrorsFactor factor({1.0, 1.0, 0.5}, {0.1, 0.1, 0.1});
  EXPECT_NEAR(factor.Evaluate({0.2, 0.3, 0.4}, {0.2, 0.3, 0.2}).norm(), 0.0, 1e-12);
}

TEST(SlowErrorsFactor, JacobiansMatchCentralDifferences) {
  const SlowErrorsFactor factor({1.0, 0.9, 0.5}, {0.1, 0.2, 0.3});
  const Eigen::Vector3d a(0.2, 0.3, 0.4), b(0.1, 0.0, -0.2);
  Eigen::Matrix3d J_a, J_b;
  EXPECT_GT(factor.Evaluate(a, b, &J_a, &J_b).norm(), 0.0);
  const auto of_a = [&](const Eigen::Vector3d& v) {
    return Eigen::VectorXd(factor.Evaluate(v, b));
  };
  const auto of_b = [&](const Eigen::Vector3d& v) {
    return Eigen::VectorXd(factor.Evaluate(a, v));
  };
  EXPECT_LT((J_a - NumericJacobian(of_a, a)).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_LT((J_b - NumericJacobian(of_b, b)).lpNorm<Eigen::Infinity>(), 1e-6);
}

}  // namespace
}  // namespace limpet
