// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limpet/imaging/water_column.hpp"
#include "limpet/simulation/image_params.hpp"

namespace limpet {

/// A lamp beside the camera that shines along its optical axis: light falls with the square of the
/// distance, with the beam's profile and with what water takes; what the water before the lens
/// sends back of it is the veil of a lamp.
class Lamp {
 public:
  Lamp(const ImageParams::Light& light, const WaterColumn& water);

  [[nodiscard]] bool is_on() const { return power_ > 0.0; }
  /// Irradiance of a surface at `p_C` [m, camera frame] that faces the lamp.
  [[nodiscard]] Eigen::Array3f LightAt(const Eigen::Vector3d& p_C) const;
  /// Unit vector from a place in the camera frame towards the lamp.
  [[nodiscard]] Eigen::Vector3d TowardsLamp(const Eigen::Vector3d& p_C) const {
    return (place_C_ - p_C).normalized();
  }
  /// What the water before a thing at `range` [m] sends into the lens, near the optical axis.
  [[nodiscard]] Eigen::Array3f Veil(double range) const;

 private:
  static constexpr double kStep = 0.1;       ///< of the table below [m]
  static constexpr double kFarthest = 12.0;  ///< beyond it the lamp adds nothing [m]

  double power_;
  double beam_;  ///< 1-sigma of the beam's profile [rad]
  WaterColumn water_;
  Eigen::Vector3d place_C_;
  std::vector<Eigen::Array3f> veil_;  ///< at multiples of kStep
};

}  // namespace limpet
