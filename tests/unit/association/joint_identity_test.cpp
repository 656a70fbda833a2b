// SPDX-License-Identifier: MIT
#include "estimation/association/joint_identity.hpp"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kOwn = 0.08;  // [m] of each place by itself

/// Things seen in sightings; those of one sighting share its drift.
class JointIdentityTest : public ::testing::Test {
 protected:
  /// Returns the thing's number. `drift`: number of the sighting, -1 for none.
  int Add(const Eigen::Vector2d& place, int drift = -1) {
    places_.emplace_back(place.x(), place.y(), 7.0);
    drifts_.push_back(drift);
    return static_cast<int>(places_.size()) - 1;
  }
  void MayBe(int thing, const std::vector<int>& options) {
    IdentityProblem::Claimant claimant{
        .thing = thing, .new_cost = -2.0 * std::log(1e-3), .options = {}};
    for (const int option : options)
      claimant.options.push_back({.thing = option, .cost = 0.0});
    problem_.claimants.push_back(claimant);
  }
  /// Drifts of two sightings differ by `step_sd`, each is off by `drift_sd`.
  std::vector<IdentityHypothesis> Solve(double drift_sd, double step_sd = 0.0) {
    const auto n = static_cast<Eigen::Index>(places_.size());
    problem_.places.resize(3 * n);
    problem_.covariance = kOwn * kOwn * Eigen::MatrixXd::Identity(3 * n, 3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      problem_.places.segment<3>(3 * i) = places_[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < n; ++j) {
        const int a = drifts_[static_cast<std::size_t>(i)],
                  b = drifts_[static_cast<std::size_t>(j)];
        if (a < 0 || b < 0) continue;
        const double shared =
            drift_sd * drift_sd + step_sd * step_sd * std::min(a, b);  // a random walk
        problem_.covariance.block<2, 2>(3 * i, 3 * j) += shared * Eigen::Matrix2d::Identity();
      }
    }
    return LikeliestIdentities(problem_);
  }
  std::vector<Eigen::Vector3d> places_;
  std::vector<int> drifts_;
  IdentityProblem problem_;
};

TEST_F(JointIdentityTest, TwinsSeenTogetherAfterDriftOfTheirDistanceAreToldApart) {
  // The first claimant lies where the other twin is known to be.
  const int left_again = Add({1.1, 0.0}, 0), right_again = Add({2.2, 0.0}, 0);
  const int left = Add({0.0, 0.0}), right = Add({1.1, 0.0});
  MayBe(left_again, {left, right});
  MayBe(right_again, {left, right});
  problem_.apart = {{left_again, right_again}, {left, right}};
  const auto hypotheses = Solve(0.8);
  EXPECT_EQ(hypotheses.front().is, (std::vector<int>{left, right}));
  EXPECT_GT(ShareOf(hypotheses, 0, left), 0.99);
}

TEST_F(JointIdentityTest, OneTwinAloneAfterDriftMayBeEither) {
  const int again = Add({0.6, 0.0}, 0);
  const int left = Add({0.0, 0.0}), right = Add({1.1, 0.0});
  MayBe(again, {left, right});
  const auto hypotheses = Solve(0.8);
  EXPECT_GT(ShareOf(hypotheses, 0, left), 0.3);
  EXPECT_GT(ShareOf(hypotheses, 0, right), 0.3);
}

TEST_F(JointIdentityTest, ALaterSightingDecidesAnEarlierOneThatSharesItsDrift) {
  const int again = Add({0.6, 0.0}, 0), lone_again = Add({9.6, 3.0}, 1);
  const int left = Add({0.0, 0.0}), right = Add({1.1, 0.0}), lone = Add({9.0, 3.0});
  MayBe(again, {left, right});
  MayBe(lone_again, {lone});
  EXPECT_GT(ShareOf(Solve(0.8, 0.1), 0, left), 0.99);
}

TEST_F(JointIdentityTest, ThingsSeenAtOneTimeAreNeverOne) {
  const int a = Add({0.1, 0.0}, 0), b = Add({-0.1, 0.0}, 0), known = Add({0.0, 0.0});
  MayBe(a, {known});
  MayBe(b, {a, known});
  problem_.apart = {{a, b}};
  for (const IdentityHypothesis& hypothesis : Solve(0.2)) {
    EXPECT_NE(hypothesis.is[0], hypothesis.is[1]);
  }
}

TEST_F(JointIdentityTest, OneFrameThatShowsTwoBoxesOfAThingIsOutweighedByItsPlace) {
  const int again = Add({0.05, 0.0}), known = Add({0.0, 0.0});
  MayBe(again, {known});
  problem_.apart = {{again, known, 9.0}};
  EXPECT_GT(ShareOf(Solve(0.0), 0, known), 0.9);
}

TEST_F(JointIdentityTest, TwoSightingsOfOneNewThingAreOneThing) {
  const int first = Add({0.0, 0.0}, 0), second = Add({0.1, 0.05}, 1);
  MayBe(first, {});
  MayBe(second, {first});
  EXPECT_GT(ShareOf(Solve(0.5, 0.1), 1, first), 0.99);
}

TEST_F(JointIdentityTest, OfAPairNearALoneThingOneIsItWhereThingsComeInPairs) {
  const int left_again = Add({0.8, 0.3}, 0), right_again = Add({1.9, 0.3}, 0);
  const int lone = Add({0.0, 0.0});
  MayBe(left_again, {lone});
  MayBe(right_again, {lone});
  problem_.apart = {{left_again, right_again}};
  problem_.pair_density = 0.05, problem_.crowding = 0.05;
  const auto hypotheses = Solve(2.0);
  EXPECT_GT(ShareOf(hypotheses, 0, lone) + ShareOf(hypotheses, 1, lone), 0.9);
}

TEST_F(JointIdentityTest, BesideALoneThingAnotherIsLikelyWhereThingsComeInPairs) {
  const int again = Add({0.9, 0.0}, 0), lone = Add({0.0, 0.0});
  MayBe(again, {lone});
  const double alone = ShareOf(Solve(0.3), 0, again);
  problem_.pair_density = 0.05, problem_.crowding = 0.05;
  EXPECT_GT(ShareOf(Solve(0.3), 0, again), alone + 0.2);
}

TEST_F(JointIdentityTest, BesideOneOfAPairAThirdIsUnlikely) {
  const int again = Add({0.9, 0.0}, 0), left = Add({0.0, 0.0}), right = Add({-1.1, 0.0});
  MayBe(again, {left, right});
  problem_.pair_density = 0.05, problem_.crowding = 0.05;
  const double beside_a_lone_one = ShareOf(Solve(0.3), 0, again);
  problem_.has_neighbour = {false, true, true};
  EXPECT_LT(ShareOf(Solve(0.3), 0, again), beside_a_lone_one - 0.2);
}

TEST_F(JointIdentityTest, WhatIsTooFarFromAllThatIsKnownIsSomethingElse) {
  const int thing = Add({3.0, 0.0}, 0), known = Add({0.0, 0.0});
  MayBe(thing, {known});
  EXPECT_EQ(Solve(0.3).front().is[0], thing);
}

TEST_F(JointIdentityTest, AMatchCostsWhatTheJointGaussianSays) {
  const int a = Add({0.3, 0.1}, 0), b = Add({1.5, -0.1}, 0);
  const int left = Add({0.0, 0.0}), right = Add({1.1, 0.0});
  MayBe(a, {left});
  MayBe(b, {right});
  const auto hypotheses = Solve(0.4);
  ASSERT_EQ(hypotheses.front().is, (std::vector<int>{left, right}));
  Eigen::Matrix<double, 6, 12> A = Eigen::Matrix<double, 6, 12>::Zero();
  A.leftCols<6>().setIdentity();
  A.rightCols<6>() = -Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::Matrix<double, 6, 1> d = A * problem_.places;
  const Eigen::Matrix<double, 6, 6> S =
      A * problem_.covariance * A.transpose() +
      problem_.model_sigma * problem_.model_sigma * Eigen::Matrix<double, 6, 6>::Identity();
  const double expected =
      d.dot(S.inverse() * d) + std::log((2.0 * 3.14159265358979 * S).determinant());
  EXPECT_NEAR(hypotheses.front().cost, expected, 1e-6);
}

TEST_F(JointIdentityTest, TakingOutATieGivesBackWhatWasKnownWithoutIt) {
  Add({0.3, 0.1}, 0), Add({1.5, -0.1}, 0), Add({0.0, 0.0});
  static_cast<void>(Solve(1.5));
  Eigen::VectorXd places = problem_.places;
  Eigen::MatrixXd P = problem_.covariance;
  constexpr double kSigma = 0.05;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3, 9);
  A.leftCols<3>().setIdentity();
  A.rightCols<3>() = -Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d S = A * P * A.transpose() + kSigma * kSigma * Eigen::Matrix3d::Identity();
  const Eigen::MatrixXd gain = P * A.transpose() * S.inverse();
  places -= gain * A * places;
  P -= gain * A * P;
  ASSERT_TRUE(TakeOutTie(places, P, {.a = 0, .b = 2}, kSigma));
  EXPECT_LT((places - problem_.places).norm(), 1e-6);
  EXPECT_LT((P - problem_.covariance).norm(), 1e-6);
}

TEST_F(JointIdentityTest, ATieThatIsNotThereIsNotTakenOut) {
  Add({0.3, 0.1}, 0), Add({0.0, 0.0});
  static_cast<void>(Solve(0.5));
  Eigen::VectorXd places = problem_.places;
  Eigen::MatrixXd P = problem_.covariance;
  EXPECT_FALSE(TakeOutTie(places, P, {.a = 0, .b = 1}, 0.05));
  EXPECT_EQ(places, problem_.places);
}

}  // namespace
}  // namespace limpet
