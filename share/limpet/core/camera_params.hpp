// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/lens_model.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// The camera's geometry as the vehicle's file and every app that needs it declare it: a member of
/// its Params, whose Describe calls `camera.Describe(visit)`. A mission says it once for all of
/// them, by its vehicle's file (there without `camera_`).
struct CameraParams {
  Radians fov_across = Radians::FromTextUnit(80.0);
  Radians fov_along = Radians::FromTextUnit(60.0);
  int width_px = 640;
  int height_px = 480;
  Eigen::Vector3d p_BC = Eigen::Vector3d::Zero();
  Radians tilt{0.0};
  std::optional<double> fx_px{}, fy_px{}, cx_px{}, cy_px{};  ///< else as angles and sizes say
  std::array<double, 5> distortion{};                        ///< k1, k2, p1, p2, k3

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
    visit("camera_at_m", p_BC, "m", "Where it is, from the body origin", InRange(-10.0, 10.0));
    visit("camera_tilt_deg", tilt,
          "How far it looks ahead of straight down; below 0: astern. The planner takes the image "
          "to lie straight below",
          InRange(-180.0_deg, 180.0_deg));
    const auto calibrated = [&visit](const char* name, std::optional<double>& field,
                                     const char* help, double most) {
      visit.Number(name, field.value_or(0.0), help, InRange(0.0, most),
                   [&field](double px) { field = px > 0.0 ? std::optional(px) : std::nullopt; });
    };
    calibrated("camera_fx_px", fx_px,
               "Focal length across [px]; 0: what the field of view makes it", 50000.0);
    calibrated("camera_fy_px", fy_px, "Focal length along [px]; 0: what the field of view makes it",
               50000.0);
    calibrated("camera_cx_px", cx_px,
               "Where its axis meets the image, from the left [px]; 0: middle", 4096.0);
    calibrated("camera_cy_px", cy_px, "Where its axis meets the image, from above [px]; 0: middle",
               4096.0);
    visit("camera_distortion", distortion, "[k1, k2, p1, p2, k3]",
          "Of its lens, radial and tangential, as OpenCV and MRPT calibrate it",
          InRange(-10.0, 10.0));
  }
  /// The image as it comes, but for the lens' distortion.
  [[nodiscard]] CameraModel pinhole() const {
    CameraModel camera = CameraModel::FromFieldOfView(
        width_px, height_px, {.across = fov_across.value(), .along = fov_along.value()});
    camera.p_BC = p_BC;
    if (tilt != Radians(0.0)) {
      camera.R_BC = RotationFromRollPitchYaw(0.0, tilt.value(), 0.0) * camera.R_BC;
    }
    camera.fx = fx_px.value_or(camera.fx);
    camera.fy = fy_px.value_or(camera.fy);
    camera.cx = cx_px.value_or(camera.cx);
    camera.cy = cy_px.value_or(camera.cy);
    return camera;
  }
  [[nodiscard]] LensDistortion lens_distortion() const {
    return {.k1 = distortion[0],
            .k2 = distortion[1],
            .p1 = distortion[2],
            .p2 = distortion[3],
            .k3 = distortion[4]};
  }
  /// REQUIRES: a distortion that does not fold the image, which a vehicle's file is refused for.
  [[nodiscard]] LensModel lens() const { return {pinhole(), lens_distortion()}; }
  /// What estimates, maps and plans works with: the lens' rectified camera.
  [[nodiscard]] CameraModel geometry() const { return lens().rectified(); }
};

/// When it makes images, as the vehicle's file and the simulated camera declare it.
struct CameraTiming {
  Hertz rate{4.0};
  Seconds latency{0.0};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("rate_hz", rate, "Frames per second", InRange(0.1_hz, 50.0_hz));
    visit("latency_s", latency, "From a frame's exposure until it is published",
          InRange(0.0_s, 3.0_s));
  }
};

}  // namespace limpet
