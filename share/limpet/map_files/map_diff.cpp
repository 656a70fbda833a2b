// SPDX-License-Identifier: MIT
#include "limpet/map_files/map_diff.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/core/statistics.hpp"

namespace limpet {
namespace {

/// A single column is no change of the ground: beams scatter.
constexpr int kLeastCells = 3;
/// Neighbours share pings and the vehicle's own errors: so many of them are worth one.
constexpr double kSharedCells = 4.0;
/// Sigmas of a patch as a whole; a map has thousands of places where one might be.
constexpr double kCertain = 6.0;

/// Differences by cell of B; not a number where not both are known.
struct Compared {
  std::vector<double> off_m, sigma_m;
};

Compared Compare(const DepthGrid& a, const DepthGrid& b, const FrameOffset& offset) {
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
  Compared compared{.off_m = std::vector<double>(b.down_m.size(), kNoNumber),
                    .sigma_m = std::vector<double>(b.down_m.size(), kNoNumber)};
  for (int row = 0; row < b.frame.rows; ++row) {
    for (int column = 0; column < b.frame.columns; ++column) {
      const std::size_t cell = b.Index(row, column);
      if (!b.IsKnown(cell)) continue;
      const Eigen::Vector3d p_A =
          offset.Undo({b.frame.north_min + (row + 0.5) * b.frame.cell_m,
                       b.frame.east_min + (column + 0.5) * b.frame.cell_m, 0.0});
      if (const auto of_a = a.At(p_A.head<2>())) {
        compared.off_m[cell] = static_cast<double>(b.down_m[cell] - a.down_m[*of_a]);
        compared.sigma_m[cell] =
            std::hypot(static_cast<double>(b.sigma_m[cell]), static_cast<double>(a.sigma_m[*of_a]));
      }
    }
  }
  return compared;
}

std::vector<double> Known(const std::vector<double>& values) {
  std::vector<double> known = values;
  std::erase_if(known, [](double value) { return std::isnan(value); });
  return known;
}

std::size_t CountKnown(const DepthGrid& grid) {
  std::size_t known = 0;
  for (std::size_t cell = 0; cell < grid.down_m.size(); ++cell)
    known += grid.IsKnown(cell) ? 1U : 0U;
  return known;
}

/// Standard deviation of what most of the values are, whatever the rest is.
double UsualSize(const std::vector<double>& values) {
  constexpr double kOfNormal = 0.6745;  // half of a normal distribution is within so many sigmas
  std::vector<double> sizes = Known(values);
  std::ranges::transform(sizes, sizes.begin(), [](double value) { return std::abs(value); });
  return UpperMedian(std::move(sizes)) / kOfNormal;
}

/// Columns side by side that are significantly deeper (sign 1), or shallower (-1).
void AddChanges(const DepthGrid& b, const std::vector<double>& left_m, const std::vector<double>& z,
                double sign, std::vector<DepthChange>& changes) {
  cv::Mat mask(b.frame.rows, b.frame.columns, CV_8U, cv::Scalar(0));
  for (int row = 0; row < b.frame.rows; ++row) {
    for (int column = 0; column < b.frame.columns; ++column) {
      const double here = sign * z[b.Index(row, column)];  // a comparison with no number is false
      mask.at<std::uint8_t>(row, column) = here > DepthDifference::kSignificant ? 255 : 0;
    }
  }
  cv::Mat labels, stats, middles;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, middles, 8);
  std::vector<DepthChange> found(static_cast<std::size_t>(count));
  std::vector<double> sum_z(found.size(), 0.0);
  for (int row = 0; row < b.frame.rows; ++row) {
    for (int column = 0; column < b.frame.columns; ++column) {
      const int label = labels.at<int>(row, column);
      const std::size_t cell = b.Index(row, column);
      if (label == 0) continue;
      DepthChange& change = found[static_cast<std::size_t>(label)];
      change.mean_m += left_m[cell] / stats.at<int>(label, cv::CC_STAT_AREA);
      sum_z[static_cast<std::size_t>(label)] += std::abs(z[cell]);
      change.z = std::abs(z[cell]) > std::abs(change.z) ? z[cell] : change.z;
    }
  }
  for (int label = 1; label < count; ++label) {
    const int cells = stats.at<int>(label, cv::CC_STAT_AREA);
    const double whole_z = sum_z[static_cast<std::size_t>(label)] / std::sqrt(kSharedCells * cells);
    if (cells < kLeastCells || whole_z < kCertain) continue;
    DepthChange& change = found[static_cast<std::size_t>(label)];
    change.north = b.frame.north_min + (middles.at<double>(label, 1) + 0.5) * b.frame.cell_m;
    change.east = b.frame.east_min + (middles.at<double>(label, 0) + 0.5) * b.frame.cell_m;
    change.area_m2 = cells * b.frame.cell_m * b.frame.cell_m;
    changes.push_back(change);
  }
}

}  // namespace

DepthDifference Difference(const DepthGrid& a, const DepthGrid& b, const FrameOffset& offset) {
  const Compared compared = Compare(a, b, offset);
  const std::vector<double> off = Known(compared.off_m);
  DepthDifference difference;
  difference.cells = off.size();
  difference.cells_a = CountKnown(a);
  difference.cells_b = CountKnown(b);
  if (off.empty()) return difference;
  difference.offset_m = UpperMedian(off);
  // Of a median; neighbouring columns share beams, so no better than one column's over ten.
  constexpr double kIndependent = 100.0;
  difference.offset_sd_m = std::sqrt(0.5 * std::numbers::pi) *
                           UpperMedian(Known(compared.sigma_m)) /
                           std::sqrt(std::min(static_cast<double>(off.size()), kIndependent));
  std::vector<double> left_m = compared.off_m, z = compared.off_m;
  for (std::size_t cell = 0; cell < left_m.size(); ++cell) {
    left_m[cell] -= difference.offset_m;
    z[cell] = left_m[cell] / compared.sigma_m[cell];
  }
  difference.sigma_scale = std::max(1.0, UsualSize(z));
  for (std::size_t cell = 0; cell < left_m.size(); ++cell) {
    z[cell] = left_m[cell] /
              std::hypot(difference.sigma_scale * compared.sigma_m[cell], difference.offset_sd_m);
    if (std::isnan(left_m[cell])) continue;
    difference.rms_m += left_m[cell] * left_m[cell] / static_cast<double>(off.size());
    difference.significant_cells += std::abs(z[cell]) > DepthDifference::kSignificant ? 1 : 0;
  }
  difference.rms_m = std::sqrt(difference.rms_m);
  AddChanges(b, left_m, z, 1.0, difference.changes);
  AddChanges(b, left_m, z, -1.0, difference.changes);
  std::ranges::stable_sort(difference.changes, std::ranges::greater{},
                           [](const DepthChange& c) { return std::abs(c.mean_m) * c.area_m2; });
  return difference;
}

}  // namespace limpet
