// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/imaging/linear_image.hpp"
#include "limpet/imaging/scene_light.hpp"
#include "limpet/imaging/solid.hpp"
#include "limpet/objects/pixel_rect.hpp"

namespace limpet {

/// Paints one solid over linear light: a ray per pixel walks to its surface.
class SolidPainter {
 public:
  /// Nothing if the solid is outside the image, reaches behind the camera, or water hides it.
  /// `solid` and `light` must outlive the painter.
  [[nodiscard]] static std::optional<SolidPainter> Make(const CameraModel& camera, const Pose& X_WB,
                                                        const Solid& solid,
                                                        const SceneLight& light);

  [[nodiscard]] double range() const { return range_; }  ///< of its middle [m]
  [[nodiscard]] const PixelRect& outline() const { return outline_; }
  /// Paints where the solid is nearer than the seabed; pixels that are more than half of it get
  /// `label` in `labels`, an image of bytes as wide and high as `image`. Returns how many do.
  int Paint(LinearImage& image, std::uint8_t* labels, std::uint8_t label) const;

 private:
  SolidPainter(const CameraModel& camera, const Pose& X_WB, const Solid& solid,
               const SceneLight& light, const PixelRect& outline);
  struct Sample {
    double coverage = 0.0;  ///< of the pixel, 0 to 1
    double range = 0.0;     ///< along the ray [m]
  };
  [[nodiscard]] Sample Walk(const Eigen::Vector3d& ray_S, double pixel_angle) const;
  [[nodiscard]] Eigen::Array3f AlbedoAt(const Eigen::Vector3d& p_S, double up) const;

  const Solid* solid_;
  const SceneLight* light_;
  CameraModel camera_;
  PixelRect outline_;
  Eigen::Matrix3d R_SC_;
  Eigen::Vector3d camera_S_;
  double range_;
  double bound_;
  bool touches_seabed_;
  Eigen::Array3f paint_, band_paint_;
  float blotches_;               ///< which part of the fouling is its own [m]
  SceneLight::Path near_, far_;  ///< at its nearest and farthest
};

}  // namespace limpet
