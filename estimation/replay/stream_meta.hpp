// SPDX-License-Identifier: MIT
// Whether meta.csv and a vehicle's file are of one vehicle.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/replay/sensor_stream.hpp"
#include "limpet/core/camera_model.hpp"
#include "limpet/core/lens_model.hpp"

namespace limpet {

/// What a vehicle's file says of what meta.csv may say, too.
struct VehicleGeometry {
  CameraModel image;  ///< as it comes, but for its lens
  LensDistortion distortion;
  Eigen::Vector3d dvl_B = Eigen::Vector3d::Zero();
};
/// What both would have to say alike, by more than calibrations differ.
struct Contradiction {
  std::string key;  ///< of meta.csv
  std::string in_meta, in_vehicle;
};
/// Contradictions between the vehicle and those keys that meta.csv says.
[[nodiscard]] std::vector<Contradiction> Contradictions(const StreamMeta& meta,
                                                        const VehicleGeometry& vehicle);

}  // namespace limpet
