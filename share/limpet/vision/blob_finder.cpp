// SPDX-License-Identifier: MIT
#include "limpet/vision/blob_finder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace limpet {
namespace {

/// A horizontal run of pixels; `parent` points to an earlier run of the same region, or to itself.
struct Run {
  int row = 0, left = 0, right = 0;
  std::size_t parent = 0;
};

std::size_t Root(std::vector<Run>& runs, std::size_t index) {
  while (runs[index].parent != index) {
    runs[index].parent = runs[runs[index].parent].parent;
    index = runs[index].parent;
  }
  return index;
}

/// Joins the run at `index` with those of the row above that touch it; `above` is moved on to the
/// first that may touch the next run.
void JoinAbove(std::vector<Run>& runs, std::size_t index, std::size_t& above,
               std::size_t above_end) {
  while (above < above_end && runs[above].right < runs[index].left) {
    ++above;
  }
  for (std::size_t i = above; i < above_end && runs[i].left <= runs[index].right; ++i) {
    const std::size_t a = Root(runs, i);
    const std::size_t b = Root(runs, index);
    runs[std::max(a, b)].parent = std::min(a, b);
  }
}

std::vector<Run> RunsOf(const Plane& plane, int level) {
  std::vector<Run> runs;
  std::size_t above = 0;
  std::size_t above_end = 0;
  for (int row = 0; row < plane.height; ++row) {
    const std::int16_t* value = plane.row(row);
    const std::size_t begin = runs.size();
    for (int column = 0; column < plane.width; ++column) {
      if (value[column] < level) {
        continue;
      }
      const int left = column;
      while (column < plane.width && value[column] >= level) {
        ++column;
      }
      const std::size_t index = runs.size();
      runs.push_back({row, left, column, index});
      JoinAbove(runs, index, above, above_end);
    }
    above = begin;
    above_end = runs.size();
  }
  return runs;
}

struct Sums {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  int left = 1 << 30, top = 1 << 30, right = 0, bottom = 0;

  void Add(const Run& run) {
    const double count = run.right - run.left;
    const double middle = 0.5 * (run.left + run.right);
    const double v = run.row + 0.5;
    n += count;
    x += count * middle;
    y += count * v;
    // Each pixel is a unit square: count^2/12 along the run, 1/12 across it.
    xx += count * (middle * middle + count * count / 12.0);
    xy += count * middle * v;
    yy += count * (v * v + 1.0 / 12.0);
    left = std::min(left, run.left);
    right = std::max(right, run.right);
    top = std::min(top, run.row);
    bottom = std::max(bottom, run.row + 1);
  }
  [[nodiscard]] Blob ToBlob() const {
    Blob blob;
    blob.area = n;
    blob.center = {x / n, y / n};
    const double cross = xy / n - blob.center.x() * blob.center.y();
    blob.covariance << xx / n - blob.center.x() * blob.center.x(), cross, cross,
        yy / n - blob.center.y() * blob.center.y();
    blob.left = left, blob.top = top, blob.right = right, blob.bottom = bottom;
    return blob;
  }
};

}  // namespace

double Blob::Fullness() const {
  return area / (4.0 * std::numbers::pi * std::sqrt(std::max(covariance.determinant(), 1e-9)));
}

double Blob::Elongation() const {
  const double half_trace = 0.5 * covariance.trace();
  const double root = std::sqrt(std::max(half_trace * half_trace - covariance.determinant(), 0.0));
  return std::sqrt((half_trace + root) / std::max(half_trace - root, 1e-9));
}

void FindBlobs(const Plane& plane, int level, double least_area, std::vector<Blob>& blobs) {
  std::vector<Run> runs = RunsOf(plane, level);
  std::vector<Sums> sums(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    sums[Root(runs, i)].Add(runs[i]);
  }
  for (const Sums& region : sums) {
    if (region.n >= least_area) {
      blobs.push_back(region.ToBlob());
    }
  }
}

}  // namespace limpet
