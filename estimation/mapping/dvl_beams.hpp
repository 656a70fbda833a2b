// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "limpet/core/frames.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// A beam's end as a point of the seabed or of an object on it.
struct BeamEnd {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< NED [m]
  bool is_seabed = false;  ///< agrees with its neighbours; an object stands out of the bottom
  std::size_t beam = 0;    ///< which of the four
};

/// How the DVL is built and mounted: four beams at azimuth 45, 135, 225, 315 deg, clockwise from
/// its own forward.
struct DvlBeams {
  Radians yaw = DvlSheet{}.yaw;
  Radians from_vertical = DvlSheet{}.beam_angle;

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("dvl_yaw_deg", yaw, "How the DVL's forward is turned from the vehicle's, clockwise",
          InRange(-180.0_deg, 180.0_deg));
    visit("dvl_beam_angle_deg", from_vertical, "Of the DVL's beams from its vertical",
          InRange(5.0_deg, 45.0_deg));
  }
};

/// Unit vectors along the beams, in the DVL's axes (forward, starboard, down) turned to the body's.
[[nodiscard]] std::array<Eigen::Vector3d, 4> BeamDirections(const DvlBeams& dvl);

/// Ends of the beams from `X_WD`, the DVL's place with the body's attitude; slant ranges in metres.
/// Ranges that neither seabed nor objects up to `tallest_object` [m] above it can give (outliers)
/// are left out.
[[nodiscard]] std::vector<BeamEnd> BeamEnds(const Pose& X_WD,
                                            const std::array<std::optional<double>, 4>& ranges,
                                            double tallest_object = 3.0, const DvlBeams& dvl = {});

}  // namespace limpet
