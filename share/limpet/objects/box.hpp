// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/core/box_extent.hpp"
#include "limpet/core/camera_model.hpp"

namespace limpet {

/// A detector's box in an image: centre and size [px], its confidence (0 to 1) and class.
struct Box {
  double u = 0.0, v = 0.0, w = 0.0, h = 0.0;
  double confidence = 0.0;
  std::string color;  ///< class: yellow, orange, green, ...
  /// NAV_LANDMARKS id of the object that pNav says it shows; nothing: of none, or not yet asked.
  std::optional<int> landmark{};
};

/// A box's edge this near the image's border is the border, not the object's edge [px]: detectors
/// place an edge no better than that.
inline constexpr double kBorderMargin = 2.0;

/// Along u and along v, in an image so many pixels wide, so many high.
[[nodiscard]] BoxExtent ExtentAcross(const Box& box, int width_px);
[[nodiscard]] BoxExtent ExtentAlong(const Box& box, int height_px);
[[nodiscard]] BoxExtent ExtentAcross(const Box& box, const CameraModel& camera);
[[nodiscard]] BoxExtent ExtentAlong(const Box& box, const CameraModel& camera);

/// True for a box that the image's border cuts anywhere: its centre and size are not the object's.
[[nodiscard]] bool IsCut(const Box& box, const CameraModel& camera);

}  // namespace limpet
