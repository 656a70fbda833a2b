// SPDX-License-Identifier: MIT
#include "estimation/navigation/former_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "estimation/matching/move_hypotheses.hpp"
#include "estimation/navigation/former_candidates.hpp"

namespace limpet {
namespace {

constexpr std::size_t kMostTakenOut = 20;  // pairs of one fit: beyond that it is no fit at all

/// Most of the weight that the offset may owe to the pair itself: less than all, or nothing else
/// would say how far the two are apart.
constexpr double kMostLeverage = 0.9;

/// Share that depth has of what no filter knows of a place: the pressure sensor knows it best.
constexpr double kDownShare = 0.5;

/// How far apart two places are along some axes and how surely.
template <int N>
struct Apart {
  Eigen::Vector<double, N> off;
  Eigen::Matrix<double, N, N> covariance;
};

/// How far the pair is apart by the offset that is left when the pair is taken out of its fit.
template <int N>
Apart<N> Without(const Apart<N>& apart, const Eigen::Matrix<double, N, N>& of_offset) {
  using Square = Eigen::Matrix<double, N, N>;
  // Gains of the pair in the fit: a share of the displacement that the offset has taken up.
  const Square leverage = of_offset * apart.covariance.inverse();
  const double most = leverage.norm();
  const Square held = most > kMostLeverage ? Square(kMostLeverage / most * leverage) : leverage;
  const Square grown = (Square::Identity() - held).inverse();
  const Square covariance = grown * apart.covariance;
  return {grown * apart.off, 0.5 * (covariance + covariance.transpose())};
}

/// `own`: with what is unknown of both places alone.
template <int N>
Apart<N> Judged(const Apart<N>& own, const Eigen::Matrix<double, N, N>& of_offset, bool is_fitted) {
  return is_fitted ? Without<N>(own, of_offset) : Apart<N>{own.off, own.covariance + of_offset};
}

/// Two places that may be one, and whether the offset was fitted to them, too.
struct Pair {
  const ObjectEstimate& former;
  const ObjectEstimate& now;
  bool is_fitted;
};

/// Level and upright apart: the first turn and the fixes tell nothing of the depth.
Displacement DisplacementOf(const Pair& pair, const SessionMatch& match,
                            const MatchingParams& params) {
  const Eigen::Matrix<double, 3, 4> J = match.offset.Jacobian(pair.former.p_W);
  const Eigen::Matrix3d of_offset = J * match.offset_cov * J.transpose();
  const double floor = params.position_floor.value();
  const Eigen::Vector3d unknown(floor, floor, kDownShare * floor);
  Eigen::Matrix3d own = pair.former.cov_W + pair.now.cov_W;
  own.diagonal() += 2.0 * unknown.cwiseAbs2();
  const Eigen::Vector3d off = pair.now.p_W - match.offset.Apply(pair.former.p_W);
  const Apart<2> level = Judged<2>({off.head<2>(), own.topLeftCorner<2, 2>()},
                                   of_offset.topLeftCorner<2, 2>(), pair.is_fitted);
  const Apart<1> upright = Judged<1>({off.tail<1>(), own.bottomRightCorner<1, 1>()},
                                     of_offset.bottomRightCorner<1, 1>(), pair.is_fitted);
  Displacement displacement;
  displacement.off_W << level.off, upright.off;
  displacement.cov_W.topLeftCorner<2, 2>() = level.covariance;
  displacement.cov_W.bottomRightCorner<1, 1>() = upright.covariance;
  return displacement;
}

double ChanceOfSamePlace(const Pair& pair, const SessionMatch& match,
                         const MatchingParams& params) {
  const MoveHypotheses weights =
      WeighMoves(DisplacementOf(pair, match, params), params.moved_within.value());
  // Of an object of another colour that is the same, the colour was wrong in one of the sessions.
  const double one_object = std::exp(-0.5 * params.ColorCost(pair.former, pair.now));
  const double same = one_object * weights.stayed;
  const double all = same + one_object * weights.moved + weights.replaced;
  return all > 0.0 ? same / all : 0.0;  // too far apart for any of them
}

}  // namespace

std::vector<double> ChancesOfSamePlace(const std::vector<ObjectEstimate>& former,
                                       const std::vector<ObjectEstimate>& now,
                                       const MatchingParams& params, const Eigen::Matrix4d& prior,
                                       SessionMatch& match) {
  FormerMatches fitted = match.now_of_former;
  std::vector<double> chances(former.size(), 1.0);
  for (std::size_t round = 0; round <= kMostTakenOut; ++round) {
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < former.size(); ++i) {
      const std::optional<int> j = match.now_of_former[i];
      if (!j) continue;
      const bool is_fitted = fitted[i].has_value();
      chances[i] = ChanceOfSamePlace({former[i], now[static_cast<std::size_t>(*j)], is_fitted},
                                     match, params);
      if (is_fitted && (!least || chances[i] < chances[*least])) least = i;
    }
    if (!least || chances[*least] >= kDecidedMatch) break;
    fitted[*least].reset();
    const SessionMatch refit = FitSessions(former, now, fitted, params, prior);
    match.offset = refit.offset;
    match.offset_cov = refit.offset_cov;
  }
  return chances;
}

}  // namespace limpet
