// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/imaging/clutter.hpp"

namespace limpet {

/// What a growth shows at a place of the seabed.
struct GrowthSample {
  float cover = 0.0F;  ///< 0 to 1
  Eigen::Array3f albedo = Eigen::Array3f::Zero();
};

/// At (east, north) of its middle over its radius, seen from above under a sun at `towards_sun_W`
/// (east, north, up; unit vector). Shadows are part of it: it reaches up to 1.5 radii.
[[nodiscard]] GrowthSample GrowthAt(const Growth& growth, float east, float north,
                                    const Eigen::Vector3f& towards_sun_W);

}  // namespace limpet
