// SPDX-License-Identifier: MIT
#include "limpet/objects/box.hpp"

namespace limpet {
namespace {

BoxExtent ExtentOf(double centre, double size, int image_px) {
  const double low = centre - 0.5 * size, high = centre + 0.5 * size;
  return {.low = low,
          .high = high,
          .is_low_cut = low<kBorderMargin, .is_high_cut = high> image_px - kBorderMargin};
}

}  // namespace

double BoxExtent::CentreOf(double half) const {
  if (is_half_cut()) {
    return is_low_cut ? high - half : low + half;
  }
  return 0.5 * (low + high);
}

BoxExtent ExtentAcross(const Box& box, int width_px) { return ExtentOf(box.u, box.w, width_px); }
BoxExtent ExtentAlong(const Box& box, int height_px) { return ExtentOf(box.v, box.h, height_px); }

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
