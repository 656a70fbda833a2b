// SPDX-License-Identifier: MIT
#include "limpet/objects/lens_box.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "limpet/objects/pixel_rect.hpp"

namespace limpet {
namespace {

constexpr double kLeastSize = 1.0;  // [px] of what is left of a box inside an image

/// Edges of what `map` makes of the ellipse that touches the box's edges.
template <class Map>
PixelRect EdgesOf(const Box& box, Map map) {
  constexpr int kPoints = 64;
  PixelRect edges{1e9, 1e9, -1e9, -1e9};
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPoints;
    const Eigen::Vector2d p = map(Eigen::Vector2d(box.u + 0.5 * box.w * std::cos(angle),
                                                  box.v + 0.5 * box.h * std::sin(angle)));
    edges = {std::min(edges.left, p.x()), std::min(edges.top, p.y()), std::max(edges.right, p.x()),
             std::max(edges.bottom, p.y())};
  }
  return edges;
}

/// The box with these edges, as far as they are in the image.
std::optional<Box> BoxWithin(const CameraModel& image, PixelRect edges, Box box) {
  edges.left = std::max(edges.left, 0.0);
  edges.top = std::max(edges.top, 0.0);
  edges.right = std::min<double>(edges.right, image.width_px);
  edges.bottom = std::min<double>(edges.bottom, image.height_px);
  if (!(edges.width() >= kLeastSize) || !(edges.height() >= kLeastSize)) return std::nullopt;
  SetRect(edges, box);
  return box;
}

}  // namespace

std::optional<Box> Rectified(const LensModel& lens, const Box& box) {
  if (lens.is_pinhole()) return box;
  if (!std::isfinite(box.u + box.v + box.w + box.h)) return std::nullopt;
  const CameraModel& to = lens.rectified();
  PixelRect edges =
      EdgesOf(box, [&](const Eigen::Vector2d& pixel) { return lens.ToPinhole(to, pixel); });
  const BoxExtent across = ExtentAcross(box, lens.image()), along = ExtentAlong(box, lens.image());
  if (across.is_low_cut) edges.left = 0.0;
  if (across.is_high_cut) edges.right = to.width_px;
  if (along.is_low_cut) edges.top = 0.0;
  if (along.is_high_cut) edges.bottom = to.height_px;
  return BoxWithin(to, edges, box);
}

RectifiedFrame Rectified(const LensModel& lens, const Detections& frame) {
  RectifiedFrame result{.frame = frame, .numbers = {}};
  result.frame.boxes.clear();
  for (int i = 0; i < static_cast<int>(frame.boxes.size()); ++i) {
    if (auto box = Rectified(lens, frame.boxes[static_cast<std::size_t>(i)])) {
      result.frame.boxes.push_back(*std::move(box));
      result.numbers.push_back(i);
    }
  }
  return result;
}

std::optional<Box> Distorted(const LensModel& lens, const Box& box) {
  if (lens.is_pinhole()) return box;
  const CameraModel& from = lens.enclosing();
  const PixelRect edges =
      EdgesOf(box, [&](const Eigen::Vector2d& pixel) { return lens.FromPinhole(from, pixel); });
  return BoxWithin(lens.image(), edges, box);
}

}  // namespace limpet
