// SPDX-License-Identifier: MIT
#include "estimation/navigation/former_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/LU>

#include "estimation/navigation/former_candidates.hpp"

namespace limpet {
namespace {

constexpr double kMoves = 0.1;        // chance that what is still about was moved
constexpr double kLeastMove = 0.5;    // [m] less is no move
constexpr double kMostMove = 2.5;     // [m] all distances between are as likely
constexpr double kOtherCame = 0.002;  // [1/m^2] of objects that took the place of one that is gone

constexpr std::size_t kMostTakenOut = 20;  // pairs of one fit: beyond that it is no fit at all

/// Most of the weight that the offset may owe to the pair itself: less than all, or nothing else
/// would say how far the two are apart.
constexpr double kMostLeverage = 0.9;

/// How far apart two places are and how surely, horizontal.
struct Displacement {
  Eigen::Vector2d off;
  Eigen::Matrix2d covariance;

  [[nodiscard]] double DensityAt(const Eigen::Vector2d& d) const {
    const Eigen::Vector2d from = off - d;
    return std::exp(-0.5 * from.dot(covariance.inverse() * from)) /
           (2.0 * std::numbers::pi * std::sqrt(covariance.determinant()));
  }
};

/// As by the offset that is left when the pair is taken out of its fit.
Displacement Without(const Eigen::Vector2d& off, const Eigen::Matrix2d& own,
                     const Eigen::Matrix2d& of_offset) {
  // Gains of the pair in the fit: a share of the displacement that the offset has taken up.
  const Eigen::Matrix2d leverage = of_offset * own.inverse();
  const double most = leverage.norm();
  const Eigen::Matrix2d held = most > kMostLeverage ? kMostLeverage / most * leverage : leverage;
  const Eigen::Matrix2d grown = (Eigen::Matrix2d::Identity() - held).inverse();
  const Eigen::Matrix2d covariance = grown * own;
  return {grown * off, 0.5 * (covariance + covariance.transpose())};
}

/// Mean density over all moves.
double DensityOfMoves(const Displacement& displacement) {
  constexpr int kDistances = 10, kCourses = 16;
  double sum = 0.0;
  for (int i = 0; i < kDistances; ++i) {
    const double distance = kLeastMove + (i + 0.5) * (kMostMove - kLeastMove) / kDistances;
    for (int k = 0; k < kCourses; ++k) {
      const double course = 2.0 * std::numbers::pi * k / kCourses;
      sum += displacement.DensityAt(distance * Eigen::Vector2d(std::cos(course), std::sin(course)));
    }
  }
  return sum / (kDistances * kCourses);
}

/// Two places that may be one, and whether the offset was fitted to them, too.
struct Pair {
  const ObjectEstimate& former;
  const ObjectEstimate& now;
  bool is_fitted;
};

double ChanceOfSamePlace(const Pair& pair, const SessionMatch& match,
                         const MatchingParams& params) {
  const Eigen::Matrix<double, 3, 4> J = match.offset.Jacobian(pair.former.p_W);
  const Eigen::Matrix2d of_offset = (J * match.offset_cov * J.transpose()).topLeftCorner<2, 2>();
  Eigen::Matrix2d own = (pair.former.cov_W + pair.now.cov_W).topLeftCorner<2, 2>();
  own.diagonal().array() += 2.0 * std::pow(params.position_floor.value(), 2);
  const Eigen::Vector2d off = (pair.now.p_W - match.offset.Apply(pair.former.p_W)).head<2>();
  const Displacement displacement =
      pair.is_fitted ? Without(off, own, of_offset) : Displacement{off, own + of_offset};
  // Of an object of another colour that is the same, the colour was wrong in one of the sessions.
  const double one_object = std::exp(-0.5 * params.ColorCost(pair.former, pair.now));
  const double same = one_object * (1.0 - kMoves) * displacement.DensityAt(Eigen::Vector2d::Zero());
  const double other = one_object * kMoves * DensityOfMoves(displacement) + kOtherCame;
  return same / (same + other);
}

}  // namespace

std::vector<double> ChancesOfSamePlace(const std::vector<ObjectEstimate>& former,
                                       const std::vector<ObjectEstimate>& now,
                                       const MatchingParams& params, const Eigen::Matrix4d& prior,
                                       SessionMatch& match) {
  std::vector<int> fitted = match.now_of_former;
  std::vector<double> chances(former.size(), 1.0);
  for (std::size_t round = 0; round <= kMostTakenOut; ++round) {
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < former.size(); ++i) {
      const int j = match.now_of_former[i];
      if (j < 0) continue;
      const bool is_fitted = fitted[i] >= 0;
      chances[i] = ChanceOfSamePlace({former[i], now[static_cast<std::size_t>(j)], is_fitted},
                                     match, params);
      if (is_fitted && (!least || chances[i] < chances[*least])) least = i;
    }
    if (!least || chances[*least] >= kDecidedMatch) break;
    fitted[*least] = -1;
    const SessionMatch refit = FitSessions(former, now, fitted, params, prior);
    match.offset = refit.offset;
    match.offset_cov = refit.offset_cov;
  }
  return chances;
}

}  // namespace limpet
