// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "limpet/figures/map_axes.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

double DistanceToSegment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double square = along.squaredNorm();
  const double f = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - f * along).norm();
}

}  // namespace

std::vector<Point> Simplified(const std::vector<Point>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<bool> is_kept(points.size(), false);
  is_kept.front() = is_kept.back() = true;
  // Ranges still to be looked at; a stack, because a recursion could be as deep as the curve is
  // long.
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = DistanceToSegment(points[i], points[first], points[last]);
      if (distance > farthest) farthest = distance, split = i;
    }
    if (split == first) continue;
    is_kept[split] = true;
    open.emplace_back(first, split);
    open.emplace_back(split, last);
  }
  std::vector<Point> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_kept[i]) out.push_back(points[i]);
  }
  return out;
}

}  // namespace limpet
