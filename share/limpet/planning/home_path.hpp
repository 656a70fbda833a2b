// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/units.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// The shortest way from `start` that ends at the point (north, east), whatever the heading there,
/// inside the region where that is possible. A point outside the region is approached as it is.
[[nodiscard]] Option HomePath(const Pose2& start, double north, double east, const Region& region,
                              Meters turn_radius);

}  // namespace limpet
