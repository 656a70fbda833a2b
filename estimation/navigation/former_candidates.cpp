// SPDX-License-Identifier: MIT
#include "estimation/navigation/former_candidates.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "estimation/matching/match_evidence.hpp"

namespace limpet {
namespace {

constexpr double kNewDensity = 0.025;  // [1/m^2] of objects that came: 0.02 at a place of 0.5 m

/// Density of the landmark's horizontal place [1/m^2] if it is the former object; 0 beyond the
/// gate.
double DensityThere(const ObjectEstimate& former, const ObjectEstimate& landmark,
                    const SessionMatch& match, const MatchingParams& params) {
  const Eigen::Matrix<double, 3, 4> J = match.offset.Jacobian(former.p_W);
  const Eigen::Matrix3d S =
      params.PairCovariance(former, landmark) + J * match.offset_cov * J.transpose();
  const Eigen::Vector3d off = landmark.p_W - match.offset.Apply(former.p_W);
  const double distance = off.dot(S.inverse() * off) + params.ColorCost(former, landmark);
  if (!(distance <= std::pow(params.gate_sigmas, 2))) {
    return 0.0;
  }
  const double area = 2.0 * std::numbers::pi * std::sqrt(S.topLeftCorner<2, 2>().determinant());
  return std::exp(-0.5 * distance) / area;
}

}  // namespace

std::vector<FormerCandidate> RivalCandidates(const std::vector<FormerObject>& former,
                                             const SessionMatch& match, int now) {
  std::vector<FormerCandidate> candidates;
  for (std::size_t i = 0; i < former.size(); ++i) {
    const double chance = match.chance(static_cast<Eigen::Index>(i), now);
    if (match.now_of_former[i] == now && chance >= kDecidedMatch) return {};
    if (chance > 1.0 - kDecidedMatch) candidates.push_back({former[i].id, chance});
  }
  return candidates;
}

std::vector<FormerCandidate> NearbyCandidates(const std::vector<FormerObject>& former,
                                              const std::vector<bool>& is_taken,
                                              const ObjectEstimate& landmark,
                                              const SessionMatch& match,
                                              const MatchingParams& params) {
  std::vector<double> weights(former.size(), 0.0);
  double total = kNewDensity;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (is_taken[i]) continue;
    weights[i] = kFormerStays * DensityThere(former[i].object, landmark, match, params);
    total += weights[i];
  }
  std::vector<FormerCandidate> candidates;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double chance = weights[i] / total;
    if (chance > 1.0 - kDecidedMatch) candidates.push_back({former[i].id, chance});
  }
  return candidates;
}

}  // namespace limpet
