// SPDX-License-Identifier: MIT
#include "tests/support/beacon_start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace limpet {
namespace {

constexpr int kStarts = 16;
constexpr int kRounds = 30;
constexpr std::size_t kFewest = 8;  // ranges
constexpr double kApart = 2.0;      // [m] at which two solutions are two
constexpr double kClearly = 25.0;   // twice the cost by which the second must be worse
constexpr double kSure = 1.5;       // 1-sigma of the place, in sigmas of a range

struct Fit {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();
  double squares = 0.0;  ///< of whitened residuals
  double sd = 0.0;       ///< of the place, both directions together [m]
};

Fit FitFrom(const std::vector<RangeFrom>& ranges, double sigma, Eigen::Vector2d p) {
  Fit fit;
  Eigen::Matrix2d H;
  for (int round = 0; round < kRounds; ++round) {
    H = 1e-9 * Eigen::Matrix2d::Identity();
    Eigen::Vector2d g = Eigen::Vector2d::Zero();
    fit.squares = 0.0;
    for (const RangeFrom& r : ranges) {
      const Eigen::Vector2d d = p - r.from;
      const double distance = std::max(d.norm(), 1e-6), off = (distance - r.range) / sigma;
      const Eigen::Vector2d J = d / (distance * sigma);
      H += J * J.transpose();
      g -= off * J;
      fit.squares += off * off;
    }
    Eigen::Vector2d step = H.ldlt().solve(g);
    constexpr double kLongest = 10.0;  // [m]
    step *= std::min(1.0, kLongest / std::max(step.norm(), 1e-9));
    p += step;
    if (step.norm() < 1e-4) break;
  }
  fit.p = p;
  // Errors of neighbouring ranges are alike: the number of ranges does not make the place sure.
  const double worth = static_cast<double>(kFewest) / static_cast<double>(ranges.size());
  fit.sd = std::sqrt(H.ldlt().solve(Eigen::Matrix2d::Identity()).trace() / worth);
  return fit;
}

}  // namespace

std::optional<Eigen::Vector2d> StartOfBeacon(const std::vector<RangeFrom>& ranges, double sigma) {
  if (ranges.size() < kFewest) {
    return std::nullopt;
  }
  std::vector<Fit> fits;
  for (int i = 0; i < kStarts; ++i) {
    const double way = 2.0 * std::numbers::pi * i / kStarts;
    fits.push_back(
        FitFrom(ranges, sigma,
                ranges.front().from +
                    ranges.front().range * Eigen::Vector2d(std::cos(way), std::sin(way))));
  }
  const Fit& best = *std::ranges::min_element(fits, {}, &Fit::squares);
  if (best.sd > kSure * sigma) {
    return std::nullopt;
  }
  const double share = static_cast<double>(kFewest) / static_cast<double>(ranges.size());
  for (const Fit& other : fits) {
    const bool is_other = (other.p - best.p).norm() > kApart;
    if (is_other && share * (other.squares - best.squares) < kClearly) return std::nullopt;
  }
  return best.p;
}

}  // namespace limpet
