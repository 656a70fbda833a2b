// SPDX-License-Identifier: MIT
#include "limpet/vision/sphere_box.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limpet {
namespace {

/// Tangents of the two angles under which a circle of `radius` about (across, ahead) touches its
/// tangents through the origin; nothing if it reaches behind.
std::optional<std::pair<double, double>> TangentSlopes(const Eigen::Vector2d& center,
                                                       double radius) {
  // A little less than a right angle, beyond which the image is at infinity.
  constexpr double kSteepest = 1.55;
  const double distance = std::hypot(center.x(), center.y());
  if (distance <= radius) {
    return std::nullopt;
  }
  const double middle = std::atan2(center.x(), center.y());
  const double half = std::asin(radius / distance);
  if (middle - half < -kSteepest || middle + half > kSteepest) {
    return std::nullopt;
  }
  return std::pair(std::tan(middle - half), std::tan(middle + half));
}

/// Fills in the visible part's rectangle and share by chords of equally spaced rows.
void ClipToImage(const CameraModel& camera, const Eigen::Vector3d& p_C, double radius,
                 SphereImage& image) {
  constexpr int kRows = 128;
  const PixelRect& outline = image.outline;
  const double step = outline.height() / kRows;
  PixelRect seen{1e9, 1e9, -1e9, -1e9};
  double inside = 0.0;
  double all = 0.0;
  for (int row = 0; row < kRows; ++row) {
    const double v = outline.top + (row + 0.5) * step;
    const std::optional<Chord> chord = ChordOfSphere(camera, v, p_C, radius);
    if (!chord) {
      continue;
    }
    all += chord->right - chord->left;
    const double left = std::max(chord->left, 0.0);
    const double right = std::min<double>(chord->right, camera.width_px);
    if (v < 0.0 || v >= camera.height_px || right <= left) {
      continue;
    }
    inside += right - left;
    seen = {std::min(seen.left, left), std::min(seen.top, v - 0.5 * step),
            std::max(seen.right, right), std::max(seen.bottom, v + 0.5 * step)};
  }
  const PixelRect frame{0.0, 0.0, static_cast<double>(camera.width_px),
                        static_cast<double>(camera.height_px)};
  image.visible = Intersection(seen, frame);
  image.visible_fraction = all > 0.0 ? inside / all : 0.0;
}

}  // namespace

std::optional<Chord> ChordOfSphere(const CameraModel& camera, double v_px,
                                   const Eigen::Vector3d& p_C, double radius) {
  // A ray d = (x, y, 1) touches where (d.c)^2 = |d|^2 (|c|^2 - r^2): quadratic in x for fixed y.
  const double y = (v_px - camera.cy) / camera.fy;
  const double k = p_C.squaredNorm() - radius * radius;
  const double q = y * p_C.y() + p_C.z();
  const double a = p_C.x() * p_C.x() - k;
  const double b = p_C.x() * q;
  const double c = q * q - k * (y * y + 1.0);
  const double discriminant = b * b - a * c;
  if (discriminant <= 0.0 || a >= 0.0) {
    return std::nullopt;
  }
  const double root = std::sqrt(discriminant);
  return Chord{camera.cx + camera.fx * (-b + root) / a, camera.cx + camera.fx * (-b - root) / a};
}

std::optional<SphereImage> ImageOfSphere(const CameraModel& camera, const Eigen::Vector3d& p_C,
                                         double radius) {
  const auto across = TangentSlopes({p_C.x(), p_C.z()}, radius);
  const auto along = TangentSlopes({p_C.y(), p_C.z()}, radius);
  if (!across || !along) {
    return std::nullopt;
  }
  SphereImage image;
  image.range = p_C.norm();
  image.outline = {camera.cx + camera.fx * across->first, camera.cy + camera.fy * along->first,
                   camera.cx + camera.fx * across->second, camera.cy + camera.fy * along->second};
  ClipToImage(camera, p_C, radius, image);
  if (image.visible_fraction <= 0.0) {
    return std::nullopt;
  }
  return image;
}

}  // namespace limpet
