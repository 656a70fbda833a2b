// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/waypoints/convex_polygon.hpp"

namespace limpet {

/// How near a straight way from a place outside comes to a convex polygon.
class RayApproach {
 public:
  /// A way that leaves `from` on `bearing` [rad clockwise from north].
  RayApproach(const ConvexPolygon& polygon, const MapPoint& from, double bearing);

  /// Least distance on the whole way [m]; 0 if it meets the polygon.
  [[nodiscard]] double distance() const { return distance_; }
  /// Least distance on its first `length` [m].
  [[nodiscard]] double Within(double length) const;

 private:
  const ConvexPolygon* polygon_;
  MapPoint from_;
  double bearing_;
  double along_ = 0.0;  ///< where on the way it is nearest [m]
  double distance_ = 0.0;
};

/// How far a straight way from `from` on `bearing` [rad clockwise from north] goes to the border of
/// a convex polygon [m], from outside or from inside; nothing if it never meets it.
[[nodiscard]] std::optional<double> DistanceToBorder(const ConvexPolygon& polygon,
                                                     const MapPoint& from, double bearing);

/// The corners of what lies within `distance` [m] of a convex polygon; its round corners by a point
/// every 30 degrees, so that the ring is a little inside.
[[nodiscard]] std::vector<MapPoint> BufferedCorners(const ConvexPolygon& polygon, double distance);

}  // namespace limpet
