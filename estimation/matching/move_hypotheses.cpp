// SPDX-License-Identifier: MIT
#include "estimation/matching/move_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr double kCarried = 0.1;       // chance that what is still about was moved over the ground
constexpr double kLifted = 0.04;       // and up or down alone
constexpr double kLeastMove = 0.5;     // [m] less is no move
constexpr double kDownOfMove = 0.1;    // [m] by which a move over the ground changes the depth
constexpr double kReplaced = 0.002;    // [1/m^2] of objects that took the place of one that is gone
constexpr double kDownOfOthers = 0.5;  // [m] by which two objects' depths differ
constexpr double kSameColor = 1.0 / 3.0;  // of two objects that have nothing to do with each other

struct Horizontal {
  Eigen::Vector2d off;
  Eigen::Matrix2d covariance;

  [[nodiscard]] double DensityAt(const Eigen::Vector2d& d) const {
    const Eigen::Vector2d from = off - d;
    return std::exp(-0.5 * from.dot(covariance.inverse() * from)) /
           (2.0 * std::numbers::pi * std::sqrt(covariance.determinant()));
  }
};

/// Mean density over all moves on the ground; all distances are as likely.
double DensityOfMoves(const Horizontal& displacement, double farthest) {
  constexpr int kDistances = 10, kCourses = 16;
  double sum = 0.0;
  for (int i = 0; i < kDistances; ++i) {
    const double distance = kLeastMove + (i + 0.5) * (farthest - kLeastMove) / kDistances;
    for (int k = 0; k < kCourses; ++k) {
      const double course = 2.0 * std::numbers::pi * k / kCourses;
      sum += displacement.DensityAt(distance * Eigen::Vector2d(std::cos(course), std::sin(course)));
    }
  }
  return sum / (kDistances * kCourses);
}

struct Vertical {
  double off = 0.0, variance = 0.0;

  /// Density where depths differ by a normal deviation of `sd` [m] beside what is unknown of both.
  [[nodiscard]] double DensityWith(double sd) const {
    const double all = variance + sd * sd;
    return std::exp(-0.5 * off * off / all) / std::sqrt(2.0 * std::numbers::pi * all);
  }
  /// Density where the object went up or down by kLeastMove to `farthest`, all as likely.
  [[nodiscard]] double DensityOfLifts(double farthest) const {
    const auto below = [this](double d) { return NormalShareBelow(d - off, variance); };
    const double up = below(-kLeastMove) - below(-farthest);
    const double down = below(farthest) - below(kLeastMove);
    return 0.5 * (up + down) / (farthest - kLeastMove);
  }
};

}  // namespace

MoveHypotheses WeighMoves(const Displacement& displacement, double farthest) {
  const double most = std::max(farthest, 2.0 * kLeastMove);
  const Horizontal level{displacement.off_W.head<2>(), displacement.cov_W.topLeftCorner<2, 2>()};
  const Vertical upright{displacement.off_W.z(), displacement.cov_W(2, 2)};
  const double in_place = level.DensityAt(Eigen::Vector2d::Zero());
  const double carried = DensityOfMoves(level, most) * upright.DensityWith(kDownOfMove);
  const double lifted = in_place * upright.DensityOfLifts(most);
  return {.stayed = (1.0 - kCarried - kLifted) * in_place * upright.DensityWith(0.0),
          .moved = kCarried * carried + kLifted * lifted,
          .replaced = kReplaced * upright.DensityWith(kDownOfOthers)};
}

double ChanceMoved(const ObjectEstimate& former, const ObjectEstimate& now, double farthest) {
  const MoveHypotheses weights =
      WeighMoves({.off_W = now.p_W - former.p_W, .cov_W = former.cov_W + now.cov_W}, farthest);
  const double all = weights.moved + kSameColor * weights.replaced;
  return all > 0.0 ? weights.moved / all : 0.0;  // too far apart for either
}

}  // namespace limpet
