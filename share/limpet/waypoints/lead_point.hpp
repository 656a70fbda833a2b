// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {

/// How a vehicle is led along a leg [m].
struct LeadRule {
  double lead = 0.0;    ///< the point steered for is this far ahead on the leg; 0: the leg's end
  double damper = 0.0;  ///< nearer to the leg than this it is up to three times as far; 0: off
};

/// Where a vehicle at `at` steers on its way along the leg; never beyond the leg's end.
[[nodiscard]] MapPoint LeadPoint(const MapLeg& leg, const MapPoint& at, const LeadRule& rule);

}  // namespace limpet
