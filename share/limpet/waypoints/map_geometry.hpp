// SPDX-License-Identifier: MIT
// Distances and bearings on the map: x east and y north of the datum [m], bearings in radians
// clockwise from north, as a yaw of the NED frame.
#pragma once

#include <cmath>

#include "limpet/shapes/shape.hpp"

namespace limpet {

[[nodiscard]] inline double DistanceBetween(const MapPoint& a, const MapPoint& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// Bearing from `from` to `to`, in (-pi, pi]; 0 if they are one point.
[[nodiscard]] inline double BearingTo(const MapPoint& from, const MapPoint& to) {
  return std::atan2(to.x - from.x, to.y - from.y);
}

/// A way in a straight line.
struct BearingAndDistance {
  double bearing = 0.0;   ///< clockwise from north [rad]
  double distance = 0.0;  ///< [m]
};
[[nodiscard]] inline MapPoint Project(const MapPoint& from, const BearingAndDistance& way) {
  return {.x = from.x + way.distance * std::sin(way.bearing),
          .y = from.y + way.distance * std::cos(way.bearing)};
}

/// A line from one place to another.
struct MapLeg {
  MapPoint from, to;

  [[nodiscard]] double length() const { return DistanceBetween(from, to); }
  /// How far along the leg, from its begin [m], the foot of the perpendicular from `at` lies; below
  /// zero before it, beyond its length after it. Zero for a leg without length.
  [[nodiscard]] double Along(const MapPoint& at) const {
    const double whole = length();
    return whole > 0.0
               ? ((at.x - from.x) * (to.x - from.x) + (at.y - from.y) * (to.y - from.y)) / whole
               : 0.0;
  }
  [[nodiscard]] MapPoint At(double along) const {
    return Project(from, {.bearing = BearingTo(from, to), .distance = along});
  }
};

}  // namespace limpet
