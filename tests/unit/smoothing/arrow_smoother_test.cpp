// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_smoother.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "estimation/smoothing/batch_solver.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/range_factor.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using namespace literals;

/// A vehicle goes round and round a square over a few objects, with drifting odometry.
class ArrowSmootherTest : public ::testing::Test {
 protected:
  void Drive(int steps, bool update = true) {
    for (int i = 0; i < steps; ++i) {
      AddPose();
      Look();
      if (update) smoother_.Update();
    }
  }
  void AddPose() {
    const int k = static_cast<int>(truth_.size());
    NavVector x = k == 0 ? NavVector::Zero() : truth_.back();
    if (k > 0) {
      const double turn = k % 20 == 0 ? 0.5 * M_PI : 0.0;
      x.head<2>() += 0.5 * Eigen::Vector2d(std::cos(x(kNavYaw)), std::sin(x(kNavYaw)));
      x(kNavYaw) += turn;
      const Eigen::Vector4d variance(4e-4, 4e-4, 1e-4, 1e-5);
      Eigen::Vector4d motion(0.5, 0.0, 0.0, turn);
      for (int i = 0; i < 4; ++i)
        motion(i) += random_.Normal(std::sqrt(variance(i)));
      NavVector guess = smoother_.PoseAt(k - 1);
      guess.head<2>() += 0.5 * Eigen::Vector2d(std::cos(guess(kNavYaw)), std::sin(guess(kNavYaw)));
      guess(kNavYaw) += motion(3);
      smoother_.AddNode(guess, Term::OnStep(XyzYawFactor(motion, variance)));
    } else {
      smoother_.AddNode(x, std::nullopt);
      const NavVector sigma = (NavVector() << 0.1, 0.1, 0.1, 0.01, 0.01, 0.01).finished();
      smoother_.AddTerm(0, Term::OnPose(PosePriorFactor(x, sigma)));
    }
    truth_.push_back(x);
    smoother_.AddTerm(k, Term::OnPose(DepthFactor(Meters(random_.Normal(0.03)), 0.03_m)));
    smoother_.AddTerm(
        k, Term::OnPose(RollPitchFactor(Radians(random_.Normal(0.005)),
                                        Radians(random_.Normal(0.005)), Radians(0.005))));
  }
  void Look() {
    const int k = static_cast<int>(truth_.size()) - 1;
    for (std::size_t j = 0; j < objects_.size(); ++j) {
      const Eigen::Vector3d p =
          CameraPointOf(camera_, truth_[static_cast<std::size_t>(k)], objects_[j]).p_C;
      if (std::abs(p.x()) > 3.0 || std::abs(p.y()) > 2.0) continue;
      if (slots_[j] < 0) {
        slots_[j] = smoother_.AddLandmark(objects_[j] + Eigen::Vector3d(0.3, -0.2, 0.4));
      }
      const Eigen::Vector2d pixel(camera_.cx + camera_.fx * p.x() / p.z() + random_.Normal(3.0),
                                  camera_.cy + camera_.fy * p.y() / p.z() + random_.Normal(3.0));
      last_look_ =
          smoother_.AddTerm(k, Term::OnSight(ReprojectionFactor(camera_, pixel, {3.0, 3.0}),
                                             slots_[j], Loss::Huber(1.345)));
      const double range = 0.5 * (std::hypot(p.x(), p.z()) + std::hypot(p.y(), p.z()));
      smoother_.AddTerm(
          k, Term::OnSight(RangeFactor(camera_, Meters(range + random_.Normal(0.3)), 0.3_m),
                           slots_[j], Loss::Huber(1.345)));
    }
  }
  double WorstDifference(const ChainGraph& graph) const {
    double worst = 0.0;
    for (int i = 0; i < graph.node_count(); ++i) {
      worst = std::max(worst, (smoother_.PoseAt(i) - graph.node(i).x).lpNorm<Eigen::Infinity>());
    }
    for (const int slot : slots_) {
      if (slot >= 0) {
        worst = std::max(worst, (smoother_.LandmarkAt(slot) - graph.landmark(slot).p).norm());
      }
    }
    return worst;
  }

  Random random_{7};
  const CameraModel camera_;
  const std::vector<Eigen::Vector3d> objects_{{5.0, 1.0, 4.0}, {9.0, 6.0, 3.0}, {2.0, 9.0, 3.5}};
  std::vector<int> slots_{-1, -1, -1};
  std::vector<NavVector> truth_;
  ArrowSmoother smoother_;
  TermId last_look_;
};

TEST_F(ArrowSmootherTest, AgreesWithTheBatchOptimumWhileItRuns) {
  Drive(200);
  ChainGraph graph = smoother_.graph();
  EXPECT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 0.01);
}

TEST_F(ArrowSmootherTest, ConvergesToTheBatchOptimum) {
  Drive(200);
  EXPECT_TRUE(smoother_.Converge().has_converged);
  ChainGraph graph = smoother_.graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 1e-4);
}

TEST_F(ArrowSmootherTest, ConvergesFromABadStartWithoutHavingUpdated) {
  Drive(120, false);
  const SolveReport report = smoother_.Converge();
  EXPECT_TRUE(report.has_converged);
  ChainGraph graph = smoother_.graph();
  EXPECT_NEAR(report.cost, SolveBatch(graph).cost, 1e-3 * report.cost);
}

TEST_F(ArrowSmootherTest, ForgetsATermThatIsTakenOut) {
  Drive(60);
  smoother_.Converge();
  const Eigen::Vector3d before = smoother_.LandmarkAt(slots_[0]);
  const Term wrong =
      Term::OnSight(ReprojectionFactor(camera_, {600.0, 20.0}, {1.0, 1.0}), slots_[0]);
  const TermId id = smoother_.AddTerm(5, wrong);
  smoother_.Converge();
  EXPECT_GT((smoother_.LandmarkAt(slots_[0]) - before).norm(), 0.02);
  smoother_.RemoveTerm(id);
  smoother_.Converge();
  EXPECT_LT((smoother_.LandmarkAt(slots_[0]) - before).norm(), 1e-3);
}

TEST_F(ArrowSmootherTest, AgreesWithTheBatchOptimumAfterALandmarkIsRemoved) {
  Drive(120);
  ASSERT_GE(slots_[0], 0);
  smoother_.RemoveLandmark(slots_[0]);
  slots_[0] = -1;
  smoother_.Update();
  ChainGraph graph = smoother_.graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 0.01);
}

TEST_F(ArrowSmootherTest, CovariancesAgreeWithTheSpreadOfTheError) {
  Drive(200);
  smoother_.Converge();
  double nees = 0.0;
  for (const int node : {20, 100, 199}) {
    const NavVector error = smoother_.PoseAt(node) - truth_[static_cast<std::size_t>(node)];
    nees += error.dot(smoother_.PoseCovariance(node).llt().solve(error)) / 18.0;
  }
  EXPECT_GT(nees, 0.2);
  EXPECT_LT(nees, 2.5);
}

TEST_F(ArrowSmootherTest, HoldsALandmarkThatNothingObserves) {
  Drive(20);
  const int slot = smoother_.AddLandmark({1.0, 2.0, 3.0});
  smoother_.Update();
  EXPECT_TRUE(smoother_.PoseAt(19).allFinite());
  EXPECT_LT((smoother_.LandmarkAt(slot) - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-9);
}

TEST_F(ArrowSmootherTest, SurvivesAChainWithoutAnyAbsoluteTerm) {
  smoother_.AddNode(NavVector::Zero(), std::nullopt);
  const Term step = Term::OnStep(XyzYawFactor({1.0, 0.0, 0.0, 0.0}, Eigen::Vector4d::Ones()));
  smoother_.AddNode(NavVector::Zero(), step);
  const SolveReport report = smoother_.Update();
  EXPECT_TRUE(smoother_.PoseAt(1).allFinite());
  EXPECT_FALSE(report.reason.empty());
}

}  // namespace
}  // namespace limpet
