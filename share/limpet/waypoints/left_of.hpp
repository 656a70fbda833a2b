// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/cross_product.hpp"
#include "limpet/shapes/shape.hpp"

namespace limpet {

/// Twice the area of the triangle of `a`, `b` and `at`: above 0 where `at` lies to the left of the
/// line from `a` to `b`, so that the three turn counter-clockwise on the map [m^2].
[[nodiscard]] inline double LeftOf(const MapPoint& a, const MapPoint& b, const MapPoint& at) {
  return CrossOf({b.x - a.x, b.y - a.y}, {at.x - a.x, at.y - a.y});
}

}  // namespace limpet
