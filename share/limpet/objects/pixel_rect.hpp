// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/objects/box.hpp"

namespace limpet {

/// Edges of an upright rectangle in pixels, right and bottom exclusive.
struct PixelRect {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] double area() const {
    return width() > 0.0 && height() > 0.0 ? width() * height() : 0.0;
  }
  [[nodiscard]] double center_u() const { return 0.5 * (left + right); }
  [[nodiscard]] double center_v() const { return 0.5 * (top + bottom); }
};

[[nodiscard]] PixelRect Intersection(const PixelRect& a, const PixelRect& b);
/// Intersection over union, 0 to 1.
[[nodiscard]] double Overlap(const PixelRect& a, const PixelRect& b);

/// A box by its edges.
[[nodiscard]] PixelRect RectOf(const Box& box);
/// Gives a box these edges.
void SetRect(const PixelRect& rect, Box& box);

}  // namespace limpet
