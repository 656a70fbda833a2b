// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "limpet/objects/box.hpp"

namespace limpet {

/// One axis of an image: focal length, principal point and length [px].
struct ImageAxis {
  double f = 0.0, c = 0.0;
  double size_px = 0.0;
};

/// A circle in the plane of the optical axis and an image axis [m].
struct CircleInView {
  double side = 0.0, depth = 0.0;
  double radius = 0.0;
};

struct ShownInterval {
  double low = 0.0, high = 0.0;  ///< [px]
};

/// Where the tangents to the circle meet the image line, within the image.
inline std::optional<ShownInterval> EdgesOf(const CircleInView& circle, const ImageAxis& axis) {
  constexpr double kNearest = 0.2;  // [m] a sphere nearer to the camera plane has no box
  const double distance = std::hypot(circle.side, circle.depth);
  if (circle.depth < kNearest || distance <= circle.radius) return std::nullopt;
  const double middle = std::atan2(circle.side, circle.depth);
  const double half = std::asin(circle.radius / distance);
  constexpr double kLimit = 1.5;  // [rad]
  const double low = axis.c + axis.f * std::tan(std::max(middle - half, -kLimit));
  const double high = axis.c + axis.f * std::tan(std::min(middle + half, kLimit));
  if (high <= 0.0 || low >= axis.size_px) return std::nullopt;
  return ShownInterval{std::max(low, 0.0), std::min(high, axis.size_px)};
}

/// Box of a sphere at `p_C`, clipped to the image; nothing when it is out of sight.
inline std::optional<Box> BoxOfSphere(const Eigen::Vector3d& p_C, double radius,
                                      const CameraModel& camera) {
  const auto u = EdgesOf({.side = p_C.x(), .depth = p_C.z(), .radius = radius},
                         {.f = camera.fx, .c = camera.cx, .size_px = 1.0 * camera.width_px});
  const auto v = EdgesOf({.side = p_C.y(), .depth = p_C.z(), .radius = radius},
                         {.f = camera.fy, .c = camera.cy, .size_px = 1.0 * camera.height_px});
  if (!u || !v) return std::nullopt;
  Box box;
  box.u = 0.5 * (u->low + u->high), box.w = u->high - u->low;
  box.v = 0.5 * (v->low + v->high), box.h = v->high - v->low;
  return box;
}

}  // namespace limpet
