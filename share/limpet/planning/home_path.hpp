// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/units.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// Source of options that lead home, for good: they may leave the operating region.
inline constexpr const char* kHomeSource = "home";
[[nodiscard]] inline bool MayEndAnywhere(const Option& option) {
  return option.source == kHomeSource;
}

/// The shortest way from `start` that ends at `home_W` (north, east), whatever the heading there,
/// inside the region where that is possible. A point outside a rectangle without zones is
/// approached as it is; otherwise the way leads through the region to where that is nearest to the
/// point or to the transit's last way point, and from there by the transit in reverse.
[[nodiscard]] Option HomePath(const Pose2& start, const PlanePoint& home_W, const Region& region,
                              Meters turn_radius);

}  // namespace limpet
