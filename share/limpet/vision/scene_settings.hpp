// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "limpet/core/camera_model.hpp"
#include "limpet/vision/seabed_relief.hpp"

namespace limpet {

/// Which camera looks at which seabed through which water.
struct SceneSettings {
  CameraModel camera;
  SeabedDepthFunction seabed_depth;  ///< [m] at (north, east) [m]; smooth over 0.25 m
  double visibility_m = 8.0;
  std::uint64_t seabed_seed = 1;  ///< of what lies and grows there: the same place in every session
  std::uint64_t noise_seed = 1;   ///< of specks, waves and sensor noise
};

}  // namespace limpet
