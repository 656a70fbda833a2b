// SPDX-License-Identifier: MIT
#include "limpet/objects/pixel_rect.hpp"

#include <algorithm>

namespace limpet {

PixelRect Intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
          std::min(a.bottom, b.bottom)};
}

double Overlap(const PixelRect& a, const PixelRect& b) {
  const double both = Intersection(a, b).area();
  const double any = a.area() + b.area() - both;
  return any > 0.0 ? both / any : 0.0;
}

PixelRect RectOf(const Box& box) {
  return {box.u - 0.5 * box.w, box.v - 0.5 * box.h, box.u + 0.5 * box.w, box.v + 0.5 * box.h};
}

void SetRect(const PixelRect& rect, Box& box) {
  box.u = rect.center_u(), box.v = rect.center_v();
  box.w = rect.width(), box.h = rect.height();
}

}  // namespace limpet
