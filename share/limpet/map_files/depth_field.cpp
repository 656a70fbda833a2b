// SPDX-License-Identifier: MIT
#include "limpet/map_files/depth_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>

#include "limpet/core/statistics.hpp"
#include "limpet/topics/grid_place.hpp"

namespace limpet {
namespace {

/// The nearest so many are asked: those behind them add nothing.
constexpr std::size_t kMostNeighbours = 12;
constexpr std::size_t kLeastNeighbours = 2;

/// Half the variance of the differences between places so far apart, less what beams scatter.
struct Lag {
  double distance_m = 0.0, half_variance_m2 = 0.0, weight = 0.0;
};

/// The variance of that form that fits the lags, by least squares, and how badly it does.
struct FittedCovariance {
  DepthCovariance covariance;
  double misfit = 0.0;
};

/// REQUIRES: a form of variance 1.
FittedCovariance FitTo(const std::vector<Lag>& lags, const DepthCovariance& form) {
  double cross = 0.0, square = 0.0;
  for (const Lag& lag : lags) {
    const double share = 1.0 - form.At(lag.distance_m);
    cross += lag.weight * share * lag.half_variance_m2;
    square += lag.weight * share * share;
  }
  FittedCovariance fitted{.covariance = form, .misfit = 0.0};
  fitted.covariance.variance_m2 = square > 0.0 ? std::max(0.0, cross / square) : 0.0;
  for (const Lag& lag : lags) {
    const double model = fitted.covariance.variance_m2 * (1.0 - form.At(lag.distance_m));
    fitted.misfit += lag.weight * std::pow(model - lag.half_variance_m2, 2);
  }
  return fitted;
}

DepthCovariance BestFitOf(const std::vector<Lag>& lags) {
  constexpr std::array kRanges_m{0.2, 0.4, 0.8, 1.6, 3.2};
  FittedCovariance best{.covariance = {}, .misfit = std::numeric_limits<double>::infinity()};
  for (const bool is_smooth : {false, true}) {
    for (const double range_m : kRanges_m) {
      const FittedCovariance fitted =
          FitTo(lags, {.variance_m2 = 1.0, .range_m = range_m, .is_smooth = is_smooth});
      if (fitted.misfit < best.misfit) best = fitted;
    }
  }
  return best.covariance;
}

}  // namespace

double DepthCovariance::At(double distance_m) const {
  if (!is_smooth) return variance_m2 * std::exp(-distance_m / range_m);
  const double scaled = std::numbers::sqrt3 * distance_m / range_m;
  return variance_m2 * (1.0 + scaled) * std::exp(-scaled);
}

DepthField::DepthField(const DepthGrid& grid) : grid_(grid) {
  FitPlane();
  FitVariogram();
}

Eigen::Vector2d DepthField::MiddleOf(int row, int column) const {
  return {grid_.frame.north_min + (row + 0.5) * grid_.frame.cell_m,
          grid_.frame.east_min + (column + 0.5) * grid_.frame.cell_m};
}

double DepthField::PlaneAt(const Eigen::Vector2d& p_W) const {
  return plane_.head<2>().dot(p_W - MiddleOf(0, 0)) + plane_.z();
}

void DepthField::FitPlane() {
  Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int row = 0; row < grid_.frame.rows; ++row) {
    for (int column = 0; column < grid_.frame.columns; ++column) {
      const std::size_t cell = grid_.Index(row, column);
      if (!grid_.IsKnown(cell)) continue;
      const Eigen::Vector2d at = MiddleOf(row, column) - MiddleOf(0, 0);
      const Eigen::Vector3d terms(at.x(), at.y(), 1.0);
      normal += terms * terms.transpose();
      sum += terms * static_cast<double>(grid_.down_m[cell]);
    }
  }
  plane_ = normal.ldlt().solve(sum);
}

void DepthField::FitVariogram() {
  constexpr int kLags = 10;
  constexpr double kOfNormal = 0.6745;  // half of a normal distribution is within so many sigmas
  std::vector<Lag> lags;
  for (int lag = 1; lag <= kLags; ++lag) {
    std::vector<double> sizes;
    double noise_m2 = 0.0;
    const auto add = [&](int row, int column, int other_row, int other_column) {
      if (other_row >= grid_.frame.rows || other_column >= grid_.frame.columns) return;
      const std::size_t one = grid_.Index(row, column),
                        other = grid_.Index(other_row, other_column);
      if (!grid_.IsKnown(one) || !grid_.IsKnown(other)) return;
      const double off = static_cast<double>(grid_.down_m[one]) - PlaneAt(MiddleOf(row, column)) -
                         static_cast<double>(grid_.down_m[other]) +
                         PlaneAt(MiddleOf(other_row, other_column));
      sizes.push_back(std::abs(off));
      noise_m2 += 0.5 * (std::pow(static_cast<double>(grid_.sigma_m[one]), 2) +
                         std::pow(static_cast<double>(grid_.sigma_m[other]), 2));
    };
    for (int row = 0; row < grid_.frame.rows; ++row) {
      for (int column = 0; column < grid_.frame.columns; ++column) {
        add(row, column, row + lag, column);
        add(row, column, row, column + lag);
      }
    }
    if (sizes.empty()) continue;
    const auto count = static_cast<double>(sizes.size());
    const double usual = UpperMedian(std::move(sizes)) / kOfNormal;  // heaps and holes are few
    lags.push_back({.distance_m = lag * grid_.frame.cell_m,
                    .half_variance_m2 = std::max(0.0, 0.5 * usual * usual - noise_m2 / count),
                    .weight = count});
  }
  covariance_ = BestFitOf(lags);
}

std::vector<DepthField::Neighbour> DepthField::NeighboursOf(const Eigen::Vector2d& p_W) const {
  const int reach = static_cast<int>(std::ceil(kReach / grid_.frame.cell_m));
  const Eigen::Vector2d cell = (p_W - MiddleOf(0, 0)) / grid_.frame.cell_m;
  const auto row = static_cast<int>(std::lround(cell.x()));
  const auto column = static_cast<int>(std::lround(cell.y()));
  std::vector<Neighbour> neighbours;
  for (int r = std::max(0, row - reach); r <= std::min(grid_.frame.rows - 1, row + reach); ++r) {
    for (int c = std::max(0, column - reach);
         c <= std::min(grid_.frame.columns - 1, column + reach); ++c) {
      const std::size_t index = grid_.Index(r, c);
      const Eigen::Vector2d middle = MiddleOf(r, c);
      const double distance = (middle - p_W).norm();
      if (distance > kReach || !grid_.IsKnown(index)) continue;
      neighbours.push_back({.p_W = middle,
                            .off_m = static_cast<double>(grid_.down_m[index]) - PlaneAt(middle),
                            .sigma_m = static_cast<double>(grid_.sigma_m[index]),
                            .distance_m = distance});
    }
  }
  std::ranges::stable_sort(neighbours, {}, &Neighbour::distance_m);
  if (neighbours.size() > kMostNeighbours) neighbours.resize(kMostNeighbours);
  return neighbours;
}

DepthField::Depth DepthField::Krige(const std::vector<Neighbour>& neighbours,
                                    const Eigen::Vector2d& p_W) const {
  const auto count = static_cast<Eigen::Index>(neighbours.size());
  Eigen::MatrixXd among(count, count);
  Eigen::VectorXd to_place(count), off(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Neighbour& one = neighbours[static_cast<std::size_t>(i)];
    to_place[i] = covariance_.At(one.distance_m);
    off[i] = one.off_m;
    for (Eigen::Index j = 0; j < count; ++j)
      among(i, j) = covariance_.At((one.p_W - neighbours[static_cast<std::size_t>(j)].p_W).norm());
    among(i, i) += one.sigma_m * one.sigma_m;
  }
  const Eigen::LLT<Eigen::MatrixXd> solver(among);
  const Eigen::VectorXd by_place = solver.solve(to_place);
  const Eigen::VectorXd by_mean = solver.solve(Eigen::VectorXd::Ones(count));
  const double left = 1.0 - by_place.sum();  // what the neighbours' own mean has to stand in for
  const Eigen::VectorXd weights = by_place + left / by_mean.sum() * by_mean;
  const double variance =
      covariance_.variance_m2 - to_place.dot(by_place) + left * left / by_mean.sum();
  return {.down_m = PlaneAt(p_W) + weights.dot(off),
          .sigma_m = std::hypot(std::sqrt(std::max(0.0, variance)), DepthMap::kShared)};
}

std::optional<DepthField::Depth> DepthField::At(const Eigen::Vector2d& p_W) const {
  if (const auto cell = grid_.At(p_W)) {
    return Depth{.down_m = static_cast<double>(grid_.down_m[*cell]),
                 .sigma_m = static_cast<double>(grid_.sigma_m[*cell])};
  }
  if (!p_W.allFinite()) return std::nullopt;
  const std::vector<Neighbour> neighbours = NeighboursOf(p_W);
  if (neighbours.size() < kLeastNeighbours) return std::nullopt;
  return Krige(neighbours, p_W);
}

}  // namespace limpet
