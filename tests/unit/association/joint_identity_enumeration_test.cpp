// SPDX-License-Identifier: MIT
// The search for identities against an enumeration of all hypotheses, each weighed at once by the
// joint Gaussian of all its pairs.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "estimation/association/joint_identity.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr int kAll = 100000;  // width that leaves nothing out

/// Claimants 0 to `claimants` - 1, then known things; places within a few metres of each other,
/// correlated; some pairs were seen at one time.
IdentityProblem RandomProblem(std::uint64_t seed, int claimants, int known) {
  Random random(seed);
  const int n = claimants + known;
  IdentityProblem problem;
  problem.places.resize(3 * n);
  for (Eigen::Index i = 0; i < problem.places.size(); ++i)
    problem.places(i) = random.Uniform(-0.8, 0.8);
  Eigen::MatrixXd root(3 * n, 3 * n);
  for (Eigen::Index i = 0; i < root.size(); ++i)
    root(i) = random.Normal(0.15);
  problem.covariance = root * root.transpose() + 0.01 * Eigen::MatrixXd::Identity(3 * n, 3 * n);
  for (int i = 0; i < claimants; ++i) {
    IdentityProblem::Claimant claimant{.thing = i,
                                       .new_cost = random.Uniform(0.0, 12.0),
                                       .overlap_cost = random.Uniform(0.0, 2.0),
                                       .options = {}};
    for (int k = 0; k < n; ++k) {
      if (k >= i && k < claimants) continue;  // no later claimant
      if (random.Chance(0.8))
        claimant.options.push_back({.thing = k, .cost = random.Uniform(0.0, 3.0)});
    }
    problem.claimants.push_back(claimant);
  }
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) {
      if (random.Chance(0.25)) problem.apart.push_back({i, k, random.Uniform(1.0, 8.0)});
    }
  }
  return problem;
}

int NameOf(const std::vector<int>& is, int thing) {
  return thing < static_cast<int>(is.size()) ? is[static_cast<std::size_t>(thing)] : thing;
}

/// -2 ln of the likelihood of a whole hypothesis; claimant i is thing i.
double CostOf(const IdentityProblem& problem, const std::vector<int>& is) {
  double cost = 0.0;
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < is.size(); ++i) {
    const IdentityProblem::Claimant& claimant = problem.claimants[i];
    if (is[i] == claimant.thing) {
      cost += claimant.new_cost + claimant.overlap_cost;
      continue;
    }
    pairs.emplace_back(claimant.thing, is[i]);
    cost += std::ranges::find(claimant.options, is[i], &IdentityProblem::Option::thing)->cost;
  }
  for (const IdentityProblem::Apart& two : problem.apart)
    cost += NameOf(is, two.a) == NameOf(is, two.b) ? two.cost : 0.0;
  const auto m = static_cast<Eigen::Index>(3 * pairs.size());
  if (m == 0) return cost;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(m, problem.places.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(3 * k);
    A.block<3, 3>(row, 3 * pairs[k].first) = Eigen::Matrix3d::Identity();
    A.block<3, 3>(row, 3 * pairs[k].second) = -Eigen::Matrix3d::Identity();
  }
  const double sigma2 = problem.model_sigma * problem.model_sigma;
  const Eigen::MatrixXd S =
      A * problem.covariance * A.transpose() + sigma2 * Eigen::MatrixXd::Identity(m, m);
  const Eigen::VectorXd d = A * problem.places;
  return cost + d.dot(S.llt().solve(d)) + std::log(S.determinant()) +
         static_cast<double>(m) * std::log(2.0 * std::numbers::pi);
}

/// All hypotheses in which a claimant is only what is not itself taken for another.
std::map<std::vector<int>, double> Enumerate(const IdentityProblem& problem) {
  std::vector<std::vector<int>> all{{}};
  for (const IdentityProblem::Claimant& claimant : problem.claimants) {
    std::vector<std::vector<int>> next;
    for (const std::vector<int>& is : all) {
      next.push_back(is);
      next.back().push_back(claimant.thing);
      for (const IdentityProblem::Option& option : claimant.options) {
        if (NameOf(is, option.thing) != option.thing) continue;
        next.push_back(is);
        next.back().push_back(option.thing);
      }
    }
    all = next;
  }
  std::map<std::vector<int>, double> costs;
  for (const std::vector<int>& is : all)
    costs[is] = CostOf(problem, is);
  return costs;
}

class AgainstEnumeration : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  const IdentityProblem problem_ = RandomProblem(GetParam(), 3, 3);
  const std::map<std::vector<int>, double> all_ = Enumerate(problem_);
};

TEST_P(AgainstEnumeration, EveryHypothesisHasTheLikelihoodOfAllItsPairsTogether) {
  for (const IdentityHypothesis& hypothesis : LikeliestIdentities(problem_, kAll)) {
    ASSERT_TRUE(all_.contains(hypothesis.is));
    EXPECT_NEAR(hypothesis.cost, all_.at(hypothesis.is), 1e-7);
  }
}

TEST_P(AgainstEnumeration, NoHypothesisWorthFollowingUpIsLeftOut) {
  const auto best = std::ranges::min_element(all_, {}, [](const auto& one) { return one.second; });
  const std::vector<IdentityHypothesis> found = LikeliestIdentities(problem_, kAll);
  EXPECT_EQ(found.front().is, best->first);
  // The search drops what is far behind on the way: nothing that could be near the best.
  for (const auto& [is, cost] : all_) {
    const bool is_found = std::ranges::count(found, is, &IdentityHypothesis::is) > 0;
    EXPECT_TRUE(is_found || cost > best->second + 10.0);
  }
}

TEST_P(AgainstEnumeration, SharesAreThoseOfTheLikelihoodAndSumToOne) {
  const std::vector<IdentityHypothesis> found = LikeliestIdentities(problem_, kAll);
  double total = 0.0;
  for (const auto& [is, cost] : all_)
    total += std::exp(-0.5 * (cost - found.front().cost));
  for (int claimant = 0; claimant < 3; ++claimant) {
    double sum = 0.0;
    for (int thing = 0; thing < 6; ++thing) {
      double share = 0.0;
      for (const auto& [is, cost] : all_) {
        if (is[static_cast<std::size_t>(claimant)] == thing)
          share += std::exp(-0.5 * (cost - found.front().cost)) / total;
      }
      sum += ShareOf(found, claimant, thing);
      EXPECT_NEAR(ShareOf(found, claimant, thing), share, 1e-3);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST_P(AgainstEnumeration, HypothesesComeBestFirst) {
  EXPECT_TRUE(
      std::ranges::is_sorted(LikeliestIdentities(problem_, kAll), {}, &IdentityHypothesis::cost));
}

TEST_P(AgainstEnumeration, ANarrowSearchFindsNothingThatIsNotAHypothesis) {
  const std::vector<IdentityHypothesis> narrow = LikeliestIdentities(problem_, 2);
  EXPECT_LE(narrow.size(), 2U);
  for (const IdentityHypothesis& hypothesis : narrow)
    EXPECT_NEAR(hypothesis.cost, all_.at(hypothesis.is), 1e-7);
}

TEST_P(AgainstEnumeration, AShiftOfTheWorldChangesNothing) {
  IdentityProblem shifted = problem_;
  for (Eigen::Index i = 0; i < shifted.places.size(); ++i)
    shifted.places(i) += i % 3 == 0 ? 120.0 : i % 3 == 1 ? -45.0 : 7.0;
  const auto here = LikeliestIdentities(problem_), there = LikeliestIdentities(shifted);
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(here[i].is, there[i].is);
    EXPECT_NEAR(here[i].cost, there[i].cost, 1e-6);
  }
}

TEST_P(AgainstEnumeration, TheOrderOfOptionsChangesNothing) {
  IdentityProblem reversed = problem_;
  for (IdentityProblem::Claimant& claimant : reversed.claimants)
    std::ranges::reverse(claimant.options);
  const auto here = LikeliestIdentities(problem_), there = LikeliestIdentities(reversed);
  ASSERT_EQ(here.size(), there.size());
  EXPECT_EQ(here.front().is, there.front().is);
  for (int thing = 0; thing < 6; ++thing)
    EXPECT_NEAR(ShareOf(here, 2, thing), ShareOf(there, 2, thing), 1e-9);
}

TEST_P(AgainstEnumeration, AThingOutOfReachChangesNoShareOfTheOthers) {
  IdentityProblem more = problem_;
  const Eigen::Index n = more.places.size();
  more.places.conservativeResize(n + 3);
  more.places.tail<3>() << 80.0, 0.0, 0.0;
  more.covariance.conservativeResize(n + 3, n + 3);
  more.covariance.rightCols<3>().setZero();
  more.covariance.bottomRows<3>().setZero();
  more.covariance.bottomRightCorner<3, 3>() = 0.01 * Eigen::Matrix3d::Identity();
  for (IdentityProblem::Claimant& claimant : more.claimants)
    claimant.options.push_back({.thing = 6, .cost = 0.0});
  const auto here = LikeliestIdentities(problem_, kAll), there = LikeliestIdentities(more, kAll);
  for (int claimant = 0; claimant < 3; ++claimant) {
    for (int thing = 0; thing < 6; ++thing)
      EXPECT_NEAR(ShareOf(here, claimant, thing), ShareOf(there, claimant, thing), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AgainstEnumeration, ::testing::Range<std::uint64_t>(1, 21));

/// A tie between two places, as the smoother has it: a measurement that their difference is zero.
TEST(TakeOutTie, IsTheInverseOfTyingTwoPlaces) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const IdentityProblem problem = RandomProblem(seed, 2, 2);
    constexpr double kSigma = 0.05;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3, 12);
    A.block<3, 3>(0, 3) = Eigen::Matrix3d::Identity();
    A.block<3, 3>(0, 9) = -Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d S =
        A * problem.covariance * A.transpose() + kSigma * kSigma * Eigen::Matrix3d::Identity();
    const Eigen::MatrixXd gain = problem.covariance * A.transpose() * S.inverse();
    Eigen::VectorXd places = problem.places - gain * (A * problem.places);
    Eigen::MatrixXd covariance = problem.covariance - gain * S * gain.transpose();
    ASSERT_TRUE(TakeOutTie(places, covariance, {.a = 1, .b = 3}, kSigma));
    EXPECT_LT((places - problem.places).norm(), 1e-6);
    EXPECT_LT((covariance - problem.covariance).norm(), 1e-6);
  }
}

TEST(TakeOutTie, ChangesNothingWhereThereWasNone) {
  IdentityProblem problem = RandomProblem(3, 2, 2);
  const Eigen::VectorXd places = problem.places;
  // Two places further apart than any tie leaves them: their difference is less certain than it.
  EXPECT_FALSE(TakeOutTie(problem.places, problem.covariance, {.a = 0, .b = 2}, 0.05));
  EXPECT_EQ(problem.places, places);
}

/// One claimant beside a known thing, which it may not be.
double CostOfNewAt(double distance, double pair_density, double crowding = 1.0,
                   bool has_neighbour = false) {
  IdentityProblem problem;
  problem.places.resize(6);
  problem.places << distance, 0.0, 0.0, 0.0, 0.0, 0.0;
  problem.covariance = 1e-4 * Eigen::MatrixXd::Identity(6, 6);
  problem.claimants.push_back({.thing = 0, .new_cost = -2.0 * std::log(1e-3), .options = {}});
  problem.pair_density = pair_density;
  problem.crowding = crowding;
  problem.pair_distance = 2.0;
  problem.has_neighbour = {false, has_neighbour};
  return LikeliestIdentities(problem).front().cost;
}

TEST(PairDensity, AddsToTheDensityOfObjectsNearAKnownOne) {
  EXPECT_NEAR(CostOfNewAt(0.5, 0.05), -2.0 * std::log(1e-3 + 0.05), 1e-6);
}

TEST(PairDensity, CountsAboutHalfAtTheEdgeAndNothingFarFromAnyKnownOne) {
  EXPECT_NEAR(CostOfNewAt(2.0, 0.05), -2.0 * std::log(1e-3 + 0.025), 0.1);
  EXPECT_NEAR(CostOfNewAt(6.0, 0.05), -2.0 * std::log(1e-3), 1e-6);
}

TEST(PairDensity, IsLessBesideAThingThatHasANeighbourAlready) {
  EXPECT_NEAR(CostOfNewAt(0.5, 0.05, 0.2, true), -2.0 * std::log(1e-3 + 0.2 * 0.05), 1e-6);
  EXPECT_NEAR(CostOfNewAt(0.5, 0.05, 0.2, false), -2.0 * std::log(1e-3 + 0.05), 1e-6);
}

}  // namespace
}  // namespace limpet
