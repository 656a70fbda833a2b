// SPDX-License-Identifier: MIT
// Which of several things are one and the same, decided together: what one pair says of the drift
// between two sightings, it says for all that was seen then.
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// Things at uncertain places, three rows each. A claimant may be one of the things named in its
/// options, or something else. Claimants are in order: an option is no later claimant.
struct IdentityProblem {
  struct Option {
    int thing = 0;
    double cost = 0.0;  ///< -2 ln of what is known but for the place: the class
  };
  struct Claimant {
    int thing = 0;
    double new_cost = 0.0;      ///< -2 ln of the likelihood [1/m^3] of something else, alone
    double overlap_cost = 0.0;  ///< -2 ln of the share of its place where something else has room
    std::vector<Option> options;
  };
  Eigen::VectorXd places;
  Eigen::MatrixXd covariance;  ///< joint, of the places, with none taken for another
  std::vector<Claimant> claimants;
  /// Things that were seen at one time, and -2 ln of the likelihood that they are one all the same.
  struct Apart {
    int a = 0, b = 0;
    double cost = 1e9;
  };
  std::vector<Apart> apart;
  double model_sigma = 0.1;  ///< [m] between two places of one thing
  /// Where things come in pairs: density of another one near one that has no neighbour.
  double pair_density = 0.0;        ///< [1/m^3]
  double crowding = 1.0;            ///< share of it near one that has a neighbour already
  double pair_distance = 2.0;       ///< what is near [m]
  std::vector<bool> has_neighbour;  ///< per thing; all without if empty
};

/// One way to see it: per claimant the thing that it is, its own number if something else.
struct IdentityHypothesis {
  std::vector<int> is;
  double cost = 0.0;  ///< -2 ln of the likelihood
};

/// The likeliest hypotheses, best first. Exact for linear Gaussian places but for the width of the
/// search. Deterministic.
[[nodiscard]] std::vector<IdentityHypothesis> LikeliestIdentities(const IdentityProblem& problem,
                                                                  int width = 48);

/// Share of the likelihood in which a claimant (index) is `thing`, named as in the hypotheses.
[[nodiscard]] double ShareOf(const std::vector<IdentityHypothesis>& hypotheses, int claimant,
                             int thing);

/// Two things, by their indices.
struct TiedPair {
  int a = 0, b = 0;
};

/// Takes out of `places` and their covariance that two things were held together with
/// `sigma`. False, and nothing changed, if they cannot have been.
[[nodiscard]] bool TakeOutTie(Eigen::VectorXd& places, Eigen::MatrixXd& covariance,
                              const TiedPair& tied, double sigma);

}  // namespace limpet
