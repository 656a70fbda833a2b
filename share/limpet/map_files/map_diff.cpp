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
#include "limpet/map_files/depth_field.hpp"

namespace limpet {
namespace {

/// A single column is no change of the ground: beams scatter.
constexpr int kLeastCells = 3;
/// Neighbours share pings, the vehicle's own errors and the columns that depths beside them are
/// taken from: so many of them are worth one.
constexpr double kSharedCells = 8.0;
/// Sigmas of a patch as a whole; a map has thousands of places where one might be.
constexpr double kCertain = 6.0;

/// Differences by cell of B; not a number where not both are known.
struct Compared {
  std::vector<double> off_m, sigma_m;
};

Compared Compare(const DepthGrid& a, const DepthGrid& b, const FrameOffset& offset) {
  const DepthField field_a(a), field_b(b);
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
  Compared compared{.off_m = std::vector<double>(b.down_m.size(), kNoNumber),
                    .sigma_m = std::vector<double>(b.down_m.size(), kNoNumber)};
  for (int row = 0; row < b.frame.rows; ++row) {
    for (int column = 0; column < b.frame.columns; ++column) {
      const std::size_t cell = b.Index(row, column);
      const Eigen::Vector2d p_B(b.frame.north_min + (row + 0.5) * b.frame.cell_m,
                                b.frame.east_min + (column + 0.5) * b.frame.cell_m);
      const Eigen::Vector2d p_A = offset.Undo({p_B.x(), p_B.y(), 0.0}).head<2>();
      if (!b.IsKnown(cell) && !a.At(p_A)) continue;  // nobody has measured there
      const auto of_a = field_a.At(p_A), of_b = field_b.At(p_B);
      if (!of_a || !of_b) continue;
      compared.off_m[cell] = of_b->down_m - of_a->down_m;
      compared.sigma_m[cell] = std::hypot(of_b->sigma_m, of_a->sigma_m);
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

/// The columns that are significantly deeper (sign 1), or shallower (-1), as a picture of 0 and
/// 255.
cv::Mat SignificantOf(const DepthGrid& b, const std::vector<double>& z, double sign) {
  cv::Mat mask(b.frame.rows, b.frame.columns, CV_8U, cv::Scalar(0));
  for (int row = 0; row < b.frame.rows; ++row) {
    for (int column = 0; column < b.frame.columns; ++column) {
      const double here = sign * z[b.Index(row, column)];  // a comparison with no number is false
      mask.at<std::uint8_t>(row, column) = here > DepthDifference::kSignificant ? 255 : 0;
    }
  }
  return mask;
}

/// With the ground between them that nobody has measured, up to two columns wide: what lies on both
/// sides of it is one patch.
cv::Mat JoinedOverGaps(const DepthGrid& b, const std::vector<double>& z, const cv::Mat& mask) {
  cv::Mat joined;
  cv::morphologyEx(mask, joined, cv::MORPH_CLOSE, cv::Mat::ones(3, 3, CV_8U));
  for (int row = 0; row < b.frame.rows; ++row) {
    for (int column = 0; column < b.frame.columns; ++column) {
      const bool is_compared = !std::isnan(z[b.Index(row, column)]);
      if (is_compared) joined.at<std::uint8_t>(row, column) = mask.at<std::uint8_t>(row, column);
    }
  }
  return joined;
}

/// A patch, and the columns of it that were compared.
struct Patch {
  DepthChange change;
  int cells = 0;
  double sum_m = 0.0, sum_z = 0.0;
};

/// Columns side by side that are significantly deeper (sign 1), or shallower (-1).
void AddChanges(const DepthGrid& b, const std::vector<double>& left_m, const std::vector<double>& z,
                double sign, std::vector<DepthChange>& changes) {
  const cv::Mat joined = JoinedOverGaps(b, z, SignificantOf(b, z, sign));
  cv::Mat labels, stats, middles;
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, middles, 8);
  std::vector<Patch> patches(static_cast<std::size_t>(count));
  for (int row = 0; row < b.frame.rows; ++row) {
    for (int column = 0; column < b.frame.columns; ++column) {
      const std::size_t cell = b.Index(row, column);
      Patch& patch = patches[static_cast<std::size_t>(labels.at<int>(row, column))];
      if (std::isnan(z[cell])) continue;
      ++patch.cells;
      patch.sum_m += left_m[cell];
      patch.sum_z += std::abs(z[cell]);
      if (std::abs(z[cell]) > std::abs(patch.change.z)) patch.change.z = z[cell];
    }
  }
  for (int label = 1; label < count; ++label) {  // 0 is all the rest
    const Patch& patch = patches[static_cast<std::size_t>(label)];
    if (patch.cells < kLeastCells ||
        patch.sum_z < kCertain * std::sqrt(kSharedCells * patch.cells)) {
      continue;
    }
    DepthChange change = patch.change;
    change.mean_m = patch.sum_m / patch.cells;
    change.north = b.frame.north_min + (middles.at<double>(label, 1) + 0.5) * b.frame.cell_m;
    change.east = b.frame.east_min + (middles.at<double>(label, 0) + 0.5) * b.frame.cell_m;
    change.area_m2 = stats.at<int>(label, cv::CC_STAT_AREA) * b.frame.cell_m * b.frame.cell_m;
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
