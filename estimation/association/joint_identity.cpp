// SPDX-License-Identifier: MIT
#include "estimation/association/joint_identity.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr double kPruned = 30.0;  // -2 ln of a likelihood ratio not worth following up

/// A hypothesis under way: its pairs' differences, whitened one after the other by the Cholesky
/// factor of their joint covariance, which grows by three rows with each pair.
struct Partial {
  IdentityHypothesis hypothesis;
  std::vector<double> has_neighbour;  ///< per thing: share of the likelihood
  std::vector<std::pair<int, int>> pairs;
  Eigen::MatrixXd factor;
  Eigen::VectorXd whitened;
};

Eigen::Index Row(int thing) { return 3 * static_cast<Eigen::Index>(thing); }

/// Covariance of (places of a - b) with (c - d).
Eigen::Matrix3d AcrossPairs(const Eigen::MatrixXd& P, std::pair<int, int> ab,
                            std::pair<int, int> cd) {
  const auto block = [&P](int i, int j) -> Eigen::Matrix3d {
    return P.block<3, 3>(Row(i), Row(j));
  };
  return block(ab.first, cd.first) - block(ab.first, cd.second) - block(ab.second, cd.first) +
         block(ab.second, cd.second);
}

/// What thing `thing` is in a hypothesis.
int NameIn(const IdentityProblem& problem, const IdentityHypothesis& hypothesis, int thing) {
  for (std::size_t i = 0; i < hypothesis.is.size(); ++i) {
    if (problem.claimants[i].thing == thing) return hypothesis.is[i];
  }
  return thing;
}

/// That `thing` is one with all that `name` stands for, though seen at one time with some of it.
double ApartCost(const IdentityProblem& problem, const IdentityHypothesis& hypothesis, int thing,
                 int name) {
  double cost = 0.0;
  for (const IdentityProblem::Apart& two : problem.apart) {
    const int other = two.a == thing ? two.b : two.b == thing ? two.a : -1;
    if (other >= 0 && NameIn(problem, hypothesis, other) == name) cost += two.cost;
  }
  return cost;
}

/// Difference of two places, given all pairs of a hypothesis.
struct Difference {
  Eigen::MatrixXd across;  ///< whitened by the pairs' factor
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
};

Difference DifferenceOf(const IdentityProblem& problem, const Partial& partial,
                        std::pair<int, int> pair) {
  const auto n = static_cast<Eigen::Index>(3 * partial.pairs.size());
  Eigen::MatrixXd across(n, 3);
  for (std::size_t i = 0; i < partial.pairs.size(); ++i) {
    across.middleRows<3>(static_cast<Eigen::Index>(3 * i)) =
        AcrossPairs(problem.covariance, partial.pairs[i], pair);
  }
  if (n > 0) partial.factor.triangularView<Eigen::Lower>().solveInPlace(across);
  Difference d;
  d.mean = problem.places.segment<3>(Row(pair.first)) -
           problem.places.segment<3>(Row(pair.second)) - across.transpose() * partial.whitened;
  d.covariance = AcrossPairs(problem.covariance, pair, pair) - across.transpose() * across;
  d.covariance.diagonal().array() += problem.model_sigma * problem.model_sigma;
  d.across = std::move(across);
  return d;
}

/// Share of a difference's likelihood within a distance.
double ShareWithin(const Difference& d, double distance) {
  const double n = std::max(d.mean.norm(), 1e-6);
  const Eigen::Vector3d u = d.mean / n;
  const double along = u.dot(d.covariance * u);
  const double usual = std::sqrt(n * n + std::max(d.covariance.trace() - along, 0.0));
  return NormalShareBelow(distance - usual, along);
}

/// Adds that a claimant is none of the others: alone, or beside one of them.
void AddNew(const IdentityProblem& problem, Partial& partial,
            const IdentityProblem::Claimant& claimant) {
  const double alone = std::exp(-0.5 * claimant.new_cost);
  const auto decided = static_cast<std::ptrdiff_t>(partial.hypothesis.is.size());
  const auto is_open = [&](int thing) {
    return std::any_of(problem.claimants.begin() + decided, problem.claimants.end(),
                       [thing](const auto& c) { return c.thing == thing; });
  };
  std::vector<double> shares(partial.has_neighbour.size(), 0.0);
  double beside = 0.0;
  for (std::size_t k = 0; problem.pair_density > 0.0 && k < shares.size(); ++k) {
    const int other = static_cast<int>(k);
    if (is_open(other) || NameIn(problem, partial.hypothesis, other) != other) continue;
    const Difference d = DifferenceOf(problem, partial, {claimant.thing, other});
    const double room = 1.0 - partial.has_neighbour[k] * (1.0 - problem.crowding);
    shares[k] = problem.pair_density * room * ShareWithin(d, problem.pair_distance);
    beside += shares[k];
  }
  for (std::size_t k = 0; beside > 0.0 && k < shares.size(); ++k)
    partial.has_neighbour[k] += (1.0 - partial.has_neighbour[k]) * shares[k] / (alone + beside);
  partial.has_neighbour[static_cast<std::size_t>(claimant.thing)] = beside / (alone + beside);
  partial.hypothesis.is.push_back(claimant.thing);
  partial.hypothesis.cost += claimant.overlap_cost - 2.0 * std::log(alone + beside);
}

/// Adds that `thing` and `same` are one: the likelihood of their distance, given all pairs before.
void AddPair(const IdentityProblem& problem, Partial& partial, int thing, int same) {
  const std::pair<int, int> pair{thing, same};
  const auto n = static_cast<Eigen::Index>(3 * partial.pairs.size());
  const Difference d = DifferenceOf(problem, partial, pair);
  const Eigen::LLT<Eigen::Matrix3d> llt(d.covariance);
  const Eigen::Matrix3d L = llt.matrixL();
  const Eigen::Vector3d w = L.triangularView<Eigen::Lower>().solve(d.mean);
  partial.hypothesis.cost += NormalCost({.distance2 = w.squaredNorm(),
                                         .log_determinant = 2.0 * L.diagonal().array().log().sum(),
                                         .dimensions = 3});
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(n + 3, n + 3);
  factor.topLeftCorner(n, n) = partial.factor;
  factor.bottomLeftCorner(3, n) = d.across.transpose();
  factor.bottomRightCorner<3, 3>() = L;
  partial.factor = std::move(factor);
  partial.whitened.conservativeResize(n + 3);
  partial.whitened.tail<3>() = w;
  partial.pairs.push_back(pair);
}

}  // namespace

std::vector<IdentityHypothesis> LikeliestIdentities(const IdentityProblem& problem, int width) {
  std::vector<Partial> beam(1), next;
  beam.front().has_neighbour.assign(static_cast<std::size_t>(problem.places.size() / 3), 0.0);
  for (std::size_t k = 0; k < problem.has_neighbour.size(); ++k)
    beam.front().has_neighbour[k] = problem.has_neighbour[k] ? 1.0 : 0.0;
  for (const IdentityProblem::Claimant& claimant : problem.claimants) {
    next.clear();
    for (const Partial& partial : beam) {
      AddNew(problem, next.emplace_back(partial), claimant);
      for (const IdentityProblem::Option& option : claimant.options) {
        // What an option itself is taken for has its own option, or is out of reach.
        if (NameIn(problem, partial.hypothesis, option.thing) != option.thing) continue;
        const double apart = ApartCost(problem, partial.hypothesis, claimant.thing, option.thing);
        if (apart > kPruned) continue;
        Partial& same = next.emplace_back(partial);
        same.hypothesis.is.push_back(option.thing);
        same.hypothesis.cost += option.cost + apart;
        AddPair(problem, same, claimant.thing, option.thing);
      }
    }
    std::ranges::stable_sort(next, {}, [](const Partial& p) { return p.hypothesis.cost; });
    const double pruned = next.front().hypothesis.cost + kPruned;
    while (static_cast<int>(next.size()) > width || next.back().hypothesis.cost > pruned)
      next.pop_back();
    std::swap(beam, next);
  }
  std::vector<IdentityHypothesis> result;
  for (Partial& partial : beam)
    result.push_back(std::move(partial.hypothesis));
  return result;
}

double ShareOf(const std::vector<IdentityHypothesis>& hypotheses, int claimant, int thing) {
  double share = 0.0, all = 0.0;
  for (const IdentityHypothesis& hypothesis : hypotheses) {
    const double likelihood = std::exp(-0.5 * (hypothesis.cost - hypotheses.front().cost));
    all += likelihood;
    share += hypothesis.is[static_cast<std::size_t>(claimant)] == thing ? likelihood : 0.0;
  }
  return share / all;
}

bool TakeOutTie(Eigen::VectorXd& places, Eigen::MatrixXd& covariance, const TiedPair& tied,
                double sigma) {
  const auto [a, b] = tied;
  const Eigen::MatrixXd across =
      covariance.middleCols<3>(Row(a)) - covariance.middleCols<3>(Row(b));
  // The tie was a measurement of the difference; taking it out is one with negative information.
  Eigen::Matrix3d S = across.middleRows<3>(Row(a)) - across.middleRows<3>(Row(b));
  S = (sigma * sigma * Eigen::Matrix3d::Identity() - S).eval();
  const Eigen::LLT<Eigen::Matrix3d> llt(S);
  if (llt.info() != Eigen::Success) {
    return false;
  }
  const Eigen::MatrixXd gain = llt.solve(across.transpose()).transpose();
  const Eigen::Vector3d d = places.segment<3>(Row(a)) - places.segment<3>(Row(b));
  places += gain * d;
  covariance += gain * across.transpose();
  return true;
}

}  // namespace limpet
