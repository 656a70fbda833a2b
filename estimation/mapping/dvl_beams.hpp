// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "limpet/core/frames.hpp"

namespace limpet {

/// A beam's end as a point of the seabed or of an object on it.
struct BeamEnd {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< NED [m]
  bool is_seabed = false;  ///< agrees with its neighbours; an object stands out of the bottom
};

/// Ends of four beams 25 deg from vertical at azimuth 45, 135, 225, 315 deg (clockwise from
/// forward) from the DVL's pose `X_WD`, slant ranges in metres. Ranges that neither seabed nor
/// objects up to `tallest_object` [m] above it can give (outliers) are left out.
[[nodiscard]] std::vector<BeamEnd> BeamEnds(const Pose& X_WD,
                                            const std::array<std::optional<double>, 4>& ranges,
                                            double tallest_object = 3.0);

}  // namespace limpet
