// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "limpet/waypoints/convex_polygon.hpp"

namespace limpet {

/// A vehicle on the map.
struct MapPose {
  MapPoint at;
  double heading = 0.0;  ///< clockwise from north [rad]
};

/// The corner by which a vehicle best begins to go round a polygon: from outside the one where it
/// turns least against the direction of its rounds, from inside the one where it turns least at
/// all. `inertia` [rad] is what the corner ahead is preferred by inside.
[[nodiscard]] std::size_t EntryCorner(const ConvexPolygon& polygon, bool is_clockwise,
                                      const MapPose& vehicle, double inertia);

/// True if rounds clockwise need the smaller turn towards their first corner.
[[nodiscard]] bool IsClockwiseBest(const ConvexPolygon& polygon, const MapPose& vehicle);

}  // namespace limpet
