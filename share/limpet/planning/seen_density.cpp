// SPDX-License-Identifier: MIT
#include "limpet/planning/seen_density.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/interval.hpp"

namespace limpet {
namespace {

constexpr double kCoarseCell = 1.0;
constexpr double kReachInSigmas = 3.0;

/// Weights of a Gaussian at whole cells, centre in the middle.
std::vector<double> Kernel(double sigma_cells) {
  const int reach = std::max(1, static_cast<int>(std::ceil(kReachInSigmas * sigma_cells)));
  std::vector<double> kernel;
  for (int i = -reach; i <= reach; ++i) {
    kernel.push_back(std::exp(-0.5 * i * i / (sigma_cells * sigma_cells)));
  }
  return kernel;
}

/// One pass of a separable convolution along the axis with `stride`.
std::vector<double> Blur(const std::vector<double>& from, int lines, int length, int line_stride,
                         int stride, const std::vector<double>& kernel) {
  const int reach = static_cast<int>(kernel.size() / 2);
  std::vector<double> to(from.size(), 0.0);
  for (int line = 0; line < lines; ++line) {
    for (int i = 0; i < length; ++i) {
      double sum = 0.0;
      for (int j = std::max(0, i - reach); j <= std::min(length - 1, i + reach); ++j) {
        sum += kernel[static_cast<std::size_t>(j - i + reach)] *
               from[static_cast<std::size_t>(line * line_stride + j * stride)];
      }
      to[static_cast<std::size_t>(line * line_stride + i * stride)] = sum;
    }
  }
  return to;
}

}  // namespace

SeenDensity::SeenDensity(const Ground& ground)
    : is_part_(ground.is_part()),
      north_min_(ground.frame().north_min),
      east_min_(ground.frame().east_min),
      cell_m_(kCoarseCell),
      rows_(static_cast<int>(std::ceil(ground.frame().rows * ground.frame().cell_m / kCoarseCell))),
      columns_(static_cast<int>(
          std::ceil(ground.frame().columns * ground.frame().cell_m / kCoarseCell))),
      density_(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), 0.0) {
  const GridFrame& frame = ground.frame();
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      const auto fine = static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                        static_cast<std::size_t>(column);
      const int coarse_row = std::min(rows_ - 1, static_cast<int>(row * frame.cell_m / cell_m_));
      const int coarse_column =
          std::min(columns_ - 1, static_cast<int>(column * frame.cell_m / cell_m_));
      density_[static_cast<std::size_t>(coarse_row * columns_ + coarse_column)] +=
          ground.levels()[fine];
    }
  }
  const std::vector<double> kernel = Kernel(ground.footprint().swath() / 3.0 / cell_m_);
  density_ = Blur(density_, rows_, columns_, columns_, 1, kernel);
  density_ = Blur(density_, columns_, rows_, 1, columns_, kernel);
  const double most = *std::max_element(density_.begin(), density_.end());
  for (double& density : density_) {
    density = most > 0.0 ? density / most : 0.0;
  }
}

double SeenDensity::At(const Eigen::Vector2d& p_W) const {
  const int row = std::clamp(static_cast<int>((p_W.x() - north_min_) / cell_m_), 0, rows_ - 1);
  const int column = std::clamp(static_cast<int>((p_W.y() - east_min_) / cell_m_), 0, columns_ - 1);
  return density_[static_cast<std::size_t>(row * columns_ + column)];
}

Pose2 SeenDensity::Sample(const Region& region, Random& random, int tries) const {
  constexpr double kAround = 5.0;  // [m] images reach into the ground from there
  const auto within = [this](double begin, int cells, double low, double high) {
    if (!is_part_) return Interval{low, high};
    return Interval{std::max(low, begin - kAround),
                    std::min(high, begin + cells * cell_m_ + kAround)};
  };
  const Interval north = within(north_min_, rows_, region.north_min(), region.north_max());
  const Interval east = within(east_min_, columns_, region.east_min(), region.east_max());
  Pose2 pose;
  for (int i = 0; i < tries; ++i) {
    pose = {.north = random.Uniform(north.low, north.high),
            .east = random.Uniform(east.low, east.high),
            .yaw = random.Uniform(-std::numbers::pi, std::numbers::pi)};
    if (random.Chance(1.0 - At({pose.north, pose.east}))) {
      break;
    }
  }
  return pose;
}

}  // namespace limpet
