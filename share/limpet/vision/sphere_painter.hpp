// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/objects/color_table.hpp"
#include "limpet/vision/linear_row.hpp"
#include "limpet/vision/seabed_relief.hpp"
#include "limpet/vision/sphere.hpp"
#include "limpet/vision/sphere_box.hpp"
#include "limpet/vision/water_optics.hpp"

namespace limpet {

/// Paints one sphere over rows of linear light by ray intersection.
class SpherePainter {
 public:
  /// Nothing if the sphere is outside the image, or so far that water hides it.
  [[nodiscard]] static std::optional<SpherePainter> Make(const CameraModel& camera,
                                                         const Pose& X_WB, const Sphere& sphere,
                                                         const WaterOptics& water,
                                                         SeabedRelief& relief);

  [[nodiscard]] double range() const { return image_.range; }
  [[nodiscard]] int first_row() const;
  [[nodiscard]] int last_row() const;  ///< exclusive
  /// `vignette_curve` is the fall of brightness per squared pixel from the image's centre.
  void PaintRow(int row, double vignette_curve, LinearRow& linear);

 private:
  SpherePainter(const CameraModel& camera, const Pose& X_WB, const Sphere& sphere,
                const WaterOptics& water, SeabedRelief& relief, const SphereImage& image);
  struct Sample {
    double coverage = 0.0;  ///< of the pixel, 0 to 1
    Eigen::Vector3d hit;    ///< camera frame [m]
  };
  [[nodiscard]] Sample Trace(const Eigen::Vector3d& ray_C) const;
  [[nodiscard]] bool IsBuried(const Eigen::Vector3d& hit_C);

  CameraModel camera_;
  WaterOptics water_;
  SeabedRelief* relief_;
  SphereImage image_;
  Eigen::Vector3d p_C_;
  double radius_;
  Albedo albedo_;
  Eigen::Matrix3d R_WC_;
  Eigen::Vector3d camera_W_;
  Eigen::Vector3d light_C_;               ///< unit vector towards the light
  std::array<double, 3> transmission_{};  ///< at range()
  double fx_;
  double fy_;
  bool touches_seabed_ = false;
};

}  // namespace limpet
