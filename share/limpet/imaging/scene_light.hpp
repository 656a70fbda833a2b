// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/imaging/caustics.hpp"
#include "limpet/imaging/lamp.hpp"
#include "limpet/imaging/water_column.hpp"
#include "limpet/simulation/image_params.hpp"
#include "limpet/vision/seabed_relief.hpp"

namespace limpet {

/// Unit vector towards the sun as seen under water, NED.
[[nodiscard]] Eigen::Vector3d TowardsSun(const ImageParams::Light& light);

/// The light of one frame: sun with caustics, lamp, and the water between camera and things.
class SceneLight {
 public:
  /// What it is made of; must outlive it.
  struct Scene {
    const ImageParams& params;
    const CameraModel& camera;
    const WaterColumn& water;
    const Lamp& lamp;
    SeabedRelief& relief;
  };
  SceneLight(const Scene& scene, Caustics::Layer caustics, const Pose& X_WB);

  struct Path {
    Eigen::Array3f direct;  ///< share of a thing's light that arrives
    Eigen::Array3f veil;    ///< what the water adds
  };
  /// Between the lens and a thing at `range` [m] along `ray_W` (unit vector).
  [[nodiscard]] Path Along(const Eigen::Vector3d& ray_W, double range) const;
  /// What a white surface at `p_W` with `normal_W` returns, under sky, sun and lamp.
  [[nodiscard]] Eigen::Array3f On(const Eigen::Vector3d& p_W,
                                  const Eigen::Vector3d& normal_W) const;
  /// Light on the seabed, without caustics, which multiply the sun's share of it.
  struct Ground {
    Eigen::Array3f light;
    float sun_share = 0.0F;  ///< 0 to 1
  };
  /// At `p_W` on a seabed that faces `normal_W`; whose tile is shaded for level ground already.
  [[nodiscard]] Ground OnGround(const Eigen::Vector3d& p_W, const Eigen::Vector3d& normal_W) const;
  [[nodiscard]] const Caustics::Layer& caustics() const { return caustics_; }
  [[nodiscard]] double SeabedDepthAt(const Eigen::Vector3d& p_W) const {
    return relief_->At(p_W.head<2>()).depth;
  }
  [[nodiscard]] const Eigen::Vector3d& camera_W() const { return camera_W_; }
  [[nodiscard]] const Eigen::Matrix3d& R_WC() const { return R_WC_; }
  [[nodiscard]] double VignetteOf(const Eigen::Vector2d& at_px) const;

 private:
  [[nodiscard]] Eigen::Array3f DaylightAt(double depth) const;
  [[nodiscard]] Eigen::Array3f LampOn(const Eigen::Vector3d& p_W,
                                      const Eigen::Vector3d& normal_W) const;

  ImageParams params_;
  CameraModel camera_;
  const WaterColumn* water_;
  const Lamp* lamp_;
  Caustics::Layer caustics_;
  SeabedRelief* relief_;
  Eigen::Matrix3d R_WC_;
  Eigen::Vector3d camera_W_;
  Eigen::Vector3d sun_W_;
  Eigen::Array3f daylight_;  ///< beside the lens
};

}  // namespace limpet
