// SPDX-License-Identifier: MIT
#include "limpet/scoring/disc_in_rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limpet {
namespace {

/// Area of the unit disc left of x = p.
double AreaLeftOf(double p) {
  const double c = std::clamp(p, -1.0, 1.0);
  return std::numbers::pi / 2.0 + c * std::sqrt(1.0 - c * c) + std::asin(c);
}

/// Area of the unit disc left of x = p and below y = q.
double AreaLeftOfAndBelow(double p, double q) {
  if (p <= -1.0 || q <= -1.0) return 0.0;
  if (p >= 1.0) return AreaLeftOf(q);
  if (q >= 1.0) return AreaLeftOf(p);
  if (p * p + q * q < 1.0) {
    // Corner inside: both half planes' halves, the rectangle to the origin, less the quarter
    // counted twice.
    return 0.5 * (AreaLeftOf(p) + AreaLeftOf(q)) + p * q - std::numbers::pi / 4.0;
  }
  if (p < 0.0 && q < 0.0) return 0.0;
  if (p < 0.0) return AreaLeftOf(p);
  if (q < 0.0) return AreaLeftOf(q);
  return AreaLeftOf(p) + AreaLeftOf(q) - std::numbers::pi;
}

}  // namespace

double ShareOfDiscInRectangle(const Eigen::Vector2d& center_R, double radius,
                              const Eigen::Vector2d& half_size_R) {
  const Eigen::Array2d off = center_R.array().abs();
  if ((off + radius <= half_size_R.array()).all()) return 1.0;
  if ((off - radius >= half_size_R.array()).any()) return 0.0;
  const Eigen::Vector2d low = (-half_size_R - center_R) / radius;
  const Eigen::Vector2d high = (half_size_R - center_R) / radius;
  const double area = AreaLeftOfAndBelow(high.x(), high.y()) -
                      AreaLeftOfAndBelow(low.x(), high.y()) -
                      AreaLeftOfAndBelow(high.x(), low.y()) + AreaLeftOfAndBelow(low.x(), low.y());
  return std::clamp(area / std::numbers::pi, 0.0, 1.0);
}

}  // namespace limpet
