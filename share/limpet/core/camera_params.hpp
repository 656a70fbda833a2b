// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/camera_model.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// The camera's geometry as every app that needs it declares it: a member of its Params, whose
/// Describe calls `camera.Describe(visit)`. A mission must say it, once for all of them:
/// plugs/plug_camera.moos.
struct CameraParams {
  Radians fov_across = Radians::FromTextUnit(80.0);
  Radians fov_along = Radians::FromTextUnit(60.0);
  int width_px = 640;
  int height_px = 480;

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit.Required("camera_fov_across_deg", fov_across,
                   "Full angle over the image's width, to starboard", InRange(10.0_deg, 150.0_deg));
    visit.Required("camera_fov_along_deg", fov_along,
                   "Full angle over the image's height, fore and aft",
                   InRange(10.0_deg, 150.0_deg));
    visit.Required("camera_width_px", width_px, "Width of the image in pixels", InRange(64, 4096));
    visit.Required("camera_height_px", height_px, "Height of the image in pixels",
                   InRange(64, 4096));
  }
  [[nodiscard]] CameraModel geometry() const {
    return CameraModel::FromFieldOfView(width_px, height_px, fov_across.value(), fov_along.value());
  }
};

}  // namespace limpet
