// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/units.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// By how much more fences may be kept off.
struct FenceSlack {
  double border = 0.0;  ///< of the region, and zones with it [m]; negative: `region` is too narrow
  double zones = 0.0;   ///< [m]
};

/// How much farther than in `region` a vehicle at `here` can keep off borders and zones, and still
/// have a full turn of `radius` at once, to the side with more room. Zones farther yet, as far as
/// `enough_zones` [m] asks for it, where the same border leaves a turn after an arc and up to 25 m
/// straight ahead: a passage that is too narrow to turn in is flown through.
[[nodiscard]] FenceSlack SlackToTurn(const Region& region, const Pose2& here, Meters radius,
                                     double enough_zones);

}  // namespace limpet
