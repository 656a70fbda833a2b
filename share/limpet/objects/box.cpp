// SPDX-License-Identifier: MIT
#include "limpet/objects/box.hpp"

#include <algorithm>

namespace limpet {
namespace {

/// What is round is not that much shorter along one axis than along the other, unless the border
/// takes the rest: of such a box an end this near the border, as a share of the longer side, is the
/// border too. A detector that sees a part places its edges worse.
constexpr double kFlat = 0.7, kFlatMargin = 0.04;

/// A box along one axis: centre and size, and its size along the other [px].
struct BoxSide {
  double centre, size, other;
};

BoxExtent ExtentOf(const BoxSide& side, int image_px) {
  const bool is_flat = side.size < kFlat * side.other;
  const double margin = is_flat ? std::max(kBorderMargin, kFlatMargin * side.other) : kBorderMargin;
  const double low = side.centre - 0.5 * side.size, high = side.centre + 0.5 * side.size;
  return {
      .low = low, .high = high, .is_low_cut = low<margin, .is_high_cut = high> image_px - margin};
}

}  // namespace

BoxExtent ExtentAcross(const Box& box, int width_px) {
  return ExtentOf({.centre = box.u, .size = box.w, .other = box.h}, width_px);
}
BoxExtent ExtentAlong(const Box& box, int height_px) {
  return ExtentOf({.centre = box.v, .size = box.h, .other = box.w}, height_px);
}

BoxExtent ExtentAcross(const Box& box, const CameraModel& camera) {
  return ExtentAcross(box, camera.width_px);
}

BoxExtent ExtentAlong(const Box& box, const CameraModel& camera) {
  return ExtentAlong(box, camera.height_px);
}

bool IsCut(const Box& box, const CameraModel& camera) {
  return ExtentAcross(box, camera).is_cut() || ExtentAlong(box, camera).is_cut();
}

}  // namespace limpet
