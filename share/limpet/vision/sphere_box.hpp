// SPDX-License-Identifier: MIT
// What a pinhole camera sees of a sphere: exact, not the projected centre with a scaled radius.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/objects/pixel_rect.hpp"

namespace limpet {

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
[[nodiscard]] std::optional<Chord> ChordOfSphere(const CameraModel& camera, double v_px,
                                                 const Eigen::Vector3d& p_C, double radius);

}  // namespace limpet
