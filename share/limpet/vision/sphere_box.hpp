// SPDX-License-Identifier: MIT
// What a pinhole camera sees of a sphere: exact, not the projected centre with a scaled radius.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"

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

/// The image of one sphere.
struct SphereImage {
  PixelRect outline;              ///< of the whole silhouette, also outside the image
  PixelRect visible;              ///< of the part inside the image
  double visible_fraction = 0.0;  ///< silhouette's area inside the image over all of it, 0 to 1
  double range = 0.0;             ///< from the camera to the sphere's centre [m]
};

/// The image of a sphere with centre `p_C` [m] in the camera frame, or nothing if no part of it is
/// inside the image or it reaches behind the camera's plane. Obstacles are not considered.
[[nodiscard]] std::optional<SphereImage> ImageOfSphere(const CameraModel& camera,
                                                       const Eigen::Vector3d& p_C, double radius);

/// Where the image row at `v_px` crosses the silhouette.
struct Chord {
  double left = 0.0, right = 0.0;
};
/// Nothing if the row misses the silhouette. REQUIRES: the sphere lies in front of the camera.
[[nodiscard]] std::optional<Chord> ChordOfSphere(const CameraModel& camera,
                                                 const Eigen::Vector3d& p_C, double radius,
                                                 double v_px);

}  // namespace limpet
