// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_smoother.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/calibrated_step_factor.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/range_factor.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "limpet/core/random.hpp"
#include "tests/support/batch_solver.hpp"

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
      if (update) smoother_->Update();
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
      NavVector guess = smoother_->PoseAt(k - 1);
      guess.head<2>() += 0.5 * Eigen::Vector2d(std::cos(guess(kNavYaw)), std::sin(guess(kNavYaw)));
      guess(kNavYaw) += motion(3);
      smoother_->AddNode(guess, Term::OnStep(XyzYawFactor(motion, variance)));
    } else {
      smoother_->AddNode(x, std::nullopt);
      const NavVector sigma = (NavVector() << 0.1, 0.1, 0.1, 0.01, 0.01, 0.01).finished();
      smoother_->AddTerm(0, Term::OnPose(PosePriorFactor(x, sigma)));
    }
    truth_.push_back(x);
    smoother_->AddTerm(k, Term::OnPose(DepthFactor(Meters(random_.Normal(0.03)), 0.03_m)));
    const Radians pitch(random_.Normal(0.005)), roll(random_.Normal(0.005));
    smoother_->AddTerm(k, Term::OnPose(RollPitchFactor(roll, pitch, Radians(0.005))));
  }
  void Look() {
    const int k = static_cast<int>(truth_.size()) - 1;
    for (std::size_t j = 0; j < objects_.size(); ++j) {
      const Eigen::Vector3d p =
          CameraPointOf(camera_, truth_[static_cast<std::size_t>(k)], objects_[j]).p_C;
      if (std::abs(p.x()) > 3.0 || std::abs(p.y()) > 2.0) continue;
      if (slots_[j] < 0) {
        slots_[j] = smoother_->AddLandmark(objects_[j] + Eigen::Vector3d(0.3, -0.2, 0.4));
      }
      const double off_v = random_.Normal(3.0), off_u = random_.Normal(3.0);
      const Eigen::Vector2d pixel(camera_.cx + camera_.fx * p.x() / p.z() + off_u,
                                  camera_.cy + camera_.fy * p.y() / p.z() + off_v);
      last_look_ =
          smoother_->AddTerm(k, Term::OnObservation(ReprojectionFactor(camera_, pixel, {3.0, 3.0}),
                                                    slots_[j], Loss::Huber(1.345)));
      const double range = 0.5 * (std::hypot(p.x(), p.z()) + std::hypot(p.y(), p.z()));
      smoother_->AddTerm(
          k, Term::OnObservation(RangeFactor(camera_, Meters(range + random_.Normal(0.3)), 0.3_m),
                                 slots_[j], Loss::Huber(1.345)));
    }
  }
  double WorstDifference(const ChainGraph& graph) const {
    double worst = 0.0;
    for (int i = 0; i < graph.node_count(); ++i) {
      worst = std::max(worst, (smoother_->PoseAt(i) - graph.node(i).x).lpNorm<Eigen::Infinity>());
    }
    for (const int slot : slots_) {
      if (slot >= 0) {
        worst = std::max(worst, (smoother_->BorderAt(slot) - graph.border(slot).x).norm());
      }
    }
    return worst;
  }

  Random random_{7};
  CameraModel camera_;
  const std::vector<Eigen::Vector3d> objects_{{5.0, 1.0, 4.0}, {9.0, 6.0, 3.0}, {2.0, 9.0, 3.5}};
  std::vector<int> slots_{-1, -1, -1};
  std::vector<NavVector> truth_;
  std::optional<ArrowSmoother> smoother_{std::in_place};
  std::optional<TermId> last_look_;
};

TEST_F(ArrowSmootherTest, AgreesWithTheBatchOptimumWhileItRuns) {
  Drive(200);
  ChainGraph graph = smoother_->graph();
  EXPECT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 0.01);
}

TEST_F(ArrowSmootherTest, ConvergesToTheBatchOptimum) {
  Drive(200);
  EXPECT_TRUE(smoother_->Converge().has_converged);
  ChainGraph graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 1e-4);
}

TEST_F(ArrowSmootherTest, ConvergesFromABadStartWithoutHavingUpdated) {
  Drive(120, false);
  const SolveReport report = smoother_->Converge();
  EXPECT_TRUE(report.has_converged);
  ChainGraph graph = smoother_->graph();
  EXPECT_NEAR(report.cost, SolveBatch(graph).cost, 1e-3 * report.cost);
}

TEST_F(ArrowSmootherTest, ForgetsATermThatIsTakenOut) {
  Drive(60);
  smoother_->Converge();
  const Eigen::Vector3d before = smoother_->BorderAt(slots_[0]);
  const Term wrong =
      Term::OnObservation(ReprojectionFactor(camera_, {600.0, 20.0}, {1.0, 1.0}), slots_[0]);
  const TermId id = smoother_->AddTerm(5, wrong);
  smoother_->Converge();
  EXPECT_GT((smoother_->BorderAt(slots_[0]) - before).norm(), 0.02);
  smoother_->RemoveTerm(id);
  smoother_->Converge();
  EXPECT_LT((smoother_->BorderAt(slots_[0]) - before).norm(), 1e-3);
}

TEST_F(ArrowSmootherTest, AgreesWithTheBatchOptimumAfterALandmarkIsRemoved) {
  Drive(120);
  ASSERT_GE(slots_[0], 0);
  smoother_->RemoveLandmark(slots_[0]);
  slots_[0] = -1;
  smoother_->Update();
  ChainGraph graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 0.01);
}

/// Inverse of the whole graph's information where its variables are.
Eigen::MatrixXd DenseCovariance(const ChainGraph& graph) {
  const int poses = 6 * graph.node_count(), n = poses + 3 * graph.slot_count();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n);
  LinearTerm linear;
  const auto add = [&](std::optional<int> previous, int pose, const Term& term) {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(linear.rows, n);
    if (previous) J.middleCols(6 * *previous, 6) = linear.J_previous.topRows(linear.rows);
    J.middleCols(6 * pose, 6) = linear.J_pose.topRows(linear.rows);
    for (std::size_t i = 0; i < term.slots().size(); ++i)
      J.middleCols(poses + 3 * term.slots()[i], 3) = linear.J_border[i].topRows(linear.rows);
    H += J.transpose() * J;
  };
  for (int i = 0; i < graph.node_count(); ++i) {
    if (i > 0) {
      graph.LinearizeStep(i, linear);
      add(i - 1, i, *graph.node(i).step);
    }
    for (const ChainNode::Entry& entry : graph.node(i).terms) {
      graph.Linearize(i, entry.term, linear);
      add(std::nullopt, i, entry.term);
    }
  }
  return H.llt().solve(Eigen::MatrixXd::Identity(n, n));
}

TEST_F(ArrowSmootherTest, CovariancesAreThoseOfTheWholeGraph) {
  Drive(40);
  smoother_->Converge();
  const Eigen::MatrixXd all = DenseCovariance(smoother_->graph());
  for (const int node : {0, 7, 16, 21, 32, 35, 39}) {
    EXPECT_LT((smoother_->PoseCovariance(node) - all.block(6 * node, 6 * node, 6, 6)).norm(),
              1e-6 * all.block(6 * node, 6 * node, 6, 6).norm())
        << "of node " << node;
  }
  ASSERT_GE(std::min(slots_[0], slots_[1]), 0);
  const Eigen::MatrixXd joint = smoother_->Covariance({slots_[0], slots_[1]});
  const Eigen::Index a = 240 + 3 * slots_[0], b = 240 + 3 * slots_[1];
  EXPECT_LT((joint.block(6, 9, 3, 3) - all.block(a, b, 3, 3)).norm(), 1e-7);
  EXPECT_LT((joint.block(0, 6, 6, 3) - all.block(6 * 39, a, 6, 3)).norm(), 1e-7);
}

TEST_F(ArrowSmootherTest, CovariancesOfAnyPosesAndLandmarksTogetherAreThoseOfTheWholeGraph) {
  Drive(75);
  smoother_->Converge();
  const Eigen::MatrixXd all = DenseCovariance(smoother_->graph());
  ASSERT_GE(std::min(slots_[0], slots_[1]), 0);
  // Anchors and insides of leaves, the head, one twice, and landmarks between.
  const std::vector<int> nodes{40, 0, 74, 48, 17, 64, 70, 40, 3}, landmarks{slots_[1], slots_[0]};
  std::vector<int> rows;
  for (const int node : nodes) {
    for (int i = 0; i < 6; ++i)
      rows.push_back(6 * node + i);
  }
  for (const int slot : landmarks) {
    for (int i = 0; i < 3; ++i)
      rows.push_back(6 * 75 + 3 * slot + i);
  }
  const Eigen::MatrixXd expected = all(rows, rows);
  const Eigen::MatrixXd joint = smoother_->CovarianceOf(nodes, landmarks);
  ASSERT_EQ(joint.rows(), expected.rows());
  EXPECT_LT((joint - expected).norm(), 1e-6 * expected.norm());
  EXPECT_LT((joint - expected)
                .cwiseQuotient(expected.diagonal().cwiseSqrt() *
                               expected.diagonal().cwiseSqrt().transpose())
                .lpNorm<Eigen::Infinity>(),
            1e-6);
}

TEST_F(ArrowSmootherTest, CovariancesHoldAtALeafsEndAndForLandmarksAlone) {
  Drive(33);  // the newest leaf has just begun: its anchor is the head
  smoother_->Converge();
  const Eigen::MatrixXd all = DenseCovariance(smoother_->graph());
  const Eigen::MatrixXd ends = smoother_->CovarianceOf({32, 31}, {});
  EXPECT_LT((ends.block(0, 6, 6, 6) - all.block(6 * 32, 6 * 31, 6, 6)).norm(), 1e-8);
  EXPECT_LT((ends.block(0, 0, 6, 6) - all.block(6 * 32, 6 * 32, 6, 6)).norm(), 1e-8);
  const Eigen::Index at = 6 * 33 + 3 * slots_[0];
  EXPECT_LT((smoother_->CovarianceOf({}, {slots_[0]}) - all.block(at, at, 3, 3)).norm(), 1e-8);
}

TEST_F(ArrowSmootherTest, CovarianceOfALandmarkThatNoUpdateHasSeenIsUnknown) {
  Drive(20);
  const int slot = smoother_->AddLandmark({1.0, 2.0, 3.0});
  const Eigen::MatrixXd joint = smoother_->CovarianceOf({3}, {slot, slots_[0]});
  EXPECT_GT(joint(6, 6), 1e7);
  EXPECT_EQ(joint.block(0, 6, 6, 3).norm(), 0.0);
  EXPECT_LT(joint(9, 9), 1e2);
}

TEST_F(ArrowSmootherTest, SpreadsTheWorkOfABigChangeOverUpdatesAndSaysWhenItIsDone) {
  ArrowParams params;
  params.work_per_update = 3e4;
  smoother_.emplace(params);
  Drive(400);
  // Something seen at the very start turns out wrong.
  smoother_->RemoveLandmark(slots_[0]);
  slots_[0] = smoother_->AddLandmark(objects_[0]);
  int updates = 0, most = 0;
  SolveReport report;
  do {
    report = smoother_->Update();
    most = std::max(most, report.eliminated_nodes);
  } while (!report.has_converged && ++updates < 200);
  EXPECT_TRUE(report.has_converged);
  EXPECT_GT(updates, 3);
  EXPECT_LE(most, 16 * 16);
  ChainGraph graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 0.02);
}

TEST_F(ArrowSmootherTest, TakesInWhatIsKnownOfSeveralLandmarksTogether) {
  Drive(120);
  // Each alone is hardly known, but how they lie to each other well: a frame that may be off by
  // metres.
  Eigen::MatrixXd covariance = 1e-4 * Eigen::MatrixXd::Identity(9, 9);
  Eigen::VectorXd mean(9);
  for (Eigen::Index i = 0; i < 9; i += 3) {
    mean.segment<3>(i) =
        objects_[static_cast<std::size_t>(i / 3)] + Eigen::Vector3d(2.0, -1.0, 0.5);
    for (Eigen::Index j = 0; j < 9; j += 3)
      covariance.block<3, 3>(i, j) += 9.0 * Eigen::Matrix3d::Identity();
  }
  smoother_->SetJointPrior(JointPrior(slots_, mean, covariance));
  smoother_->Update();
  const Eigen::Vector3d between = smoother_->BorderAt(slots_[1]) - smoother_->BorderAt(slots_[0]);
  EXPECT_LT((between - (objects_[1] - objects_[0])).norm(), 0.04);
  EXPECT_LT((smoother_->BorderAt(slots_[0]) - objects_[0]).norm(), 0.3);
  EXPECT_TRUE(smoother_->Converge().has_converged);
  ChainGraph graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 1e-4);
  // A landmark that is removed leaves what is known of the others.
  smoother_->RemoveLandmark(slots_[2]);
  slots_[2] = -1;
  EXPECT_EQ(smoother_->graph().joint_prior()->slots(), std::vector<int>({slots_[0], slots_[1]}));
  smoother_->Converge();
  graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_LT(WorstDifference(graph), 1e-4);
}

TEST_F(ArrowSmootherTest, FindsTheScaleOfItsSteps) {
  const int errors = smoother_->AddSensorErrors(Eigen::Vector3d::Zero());
  smoother_->AddBorderTerm(
      errors,
      Term::OnBorder(BorderPriorFactor(Eigen::Vector3d::Zero(), 1e-4 * Eigen::Matrix3d::Identity()),
                     errors));
  const Eigen::Vector4d variance(1e-6, 1e-6, 1e-6, 1e-8);
  for (int k = 0; k < 40; ++k) {
    const NavVector truth = (NavVector() << 0.5 * k, 0.0, 0.0, 0.0, 0.0, 0.0).finished();
    if (k == 0) {
      smoother_->AddNode(truth, std::nullopt);
    } else {
      const CalibratedStepFactor step({0.505, 0.0, 0.0, 0.0}, variance, 1.0);
      smoother_->AddNode(truth, Term::OnStep(step, std::array{errors}));
    }
    const NavVector sigma = NavVector::Constant(0.01);
    smoother_->AddTerm(k, Term::OnPose(PosePriorFactor(truth, sigma)));
    smoother_->Update();
  }
  EXPECT_NEAR(smoother_->BorderAt(errors).x(), 0.01, 1e-3);
  ChainGraph graph = smoother_->graph();
  ASSERT_TRUE(SolveBatch(graph).has_converged);
  EXPECT_NEAR(smoother_->BorderAt(errors).x(), graph.border(errors).x.x(), 1e-6);
}

TEST_F(ArrowSmootherTest, AChangeFarBackCostsAFewLeavesHoweverLongTheChain) {
  Drive(1100);
  while (!smoother_->Update().has_converged) {
  }
  const Term wrong = Term::OnPose(PosePriorFactor(smoother_->PoseAt(40), NavVector::Constant(1.0)));
  smoother_->RemoveTerm(smoother_->AddTerm(40, wrong));
  int nodes = 0;
  SolveReport report;
  do {
    report = smoother_->Update();
    nodes += report.eliminated_nodes;
  } while (!report.has_converged);
  EXPECT_LE(nodes, 4 * ArrowLeaf::kNodes);
}

TEST_F(ArrowSmootherTest, CovariancesAgreeWithTheSpreadOfTheError) {
  Drive(200);
  smoother_->Converge();
  double nees = 0.0;
  for (const int node : {20, 100, 199}) {
    const NavVector error = smoother_->PoseAt(node) - truth_[static_cast<std::size_t>(node)];
    nees += error.dot(smoother_->PoseCovariance(node).llt().solve(error)) / 18.0;
  }
  EXPECT_GT(nees, 0.2);
  EXPECT_LT(nees, 2.5);
}

TEST_F(ArrowSmootherTest, HoldsALandmarkThatNothingObserves) {
  Drive(20);
  const int slot = smoother_->AddLandmark({1.0, 2.0, 3.0});
  smoother_->Update();
  EXPECT_TRUE(smoother_->PoseAt(19).allFinite());
  EXPECT_LT((smoother_->BorderAt(slot) - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-9);
}

TEST_F(ArrowSmootherTest, SurvivesAChainWithoutAnyAbsoluteTerm) {
  smoother_->AddNode(NavVector::Zero(), std::nullopt);
  const Term step = Term::OnStep(XyzYawFactor({1.0, 0.0, 0.0, 0.0}, Eigen::Vector4d::Ones()));
  smoother_->AddNode(NavVector::Zero(), step);
  const SolveReport report = smoother_->Update();
  EXPECT_TRUE(smoother_->PoseAt(1).allFinite());
  EXPECT_FALSE(report.reason.empty());
}

}  // namespace
}  // namespace limpet
