// SPDX-License-Identifier: MIT
#include "limpet/waypoints/ray_approach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "limpet/core/cross_product.hpp"
#include "limpet/waypoints/left_of.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

/// What of a line lies within a polygon, from its begin on [m].
struct Crossing {
  double first, last;
};

/// Where a way is within the polygon, by clipping it at one edge after the other; the first is
/// negative for a way that begins inside.
std::optional<Crossing> CrossingOf(const ConvexPolygon& polygon, const MapPoint& from,
                                   double bearing) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d step(std::sin(bearing), std::cos(bearing));  // east, north
  Crossing crossing{.first = -kFar, .last = kFar};
  const std::vector<MapPoint>& corners = polygon.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const MapPoint& a = corners[i];
    const MapPoint& b = corners[(i + 1) % corners.size()];
    // Corners are clockwise: what is inside lies to the right of each edge.
    const double beyond = LeftOf(a, b, from);
    const double rate = CrossOf({b.x - a.x, b.y - a.y}, step);
    if (rate == 0.0) {
      if (beyond > 0.0) return std::nullopt;
    } else if (rate < 0.0) {
      crossing.first = std::max(crossing.first, -beyond / rate);
    } else {
      crossing.last = std::min(crossing.last, -beyond / rate);
    }
  }
  const bool meets = crossing.first <= crossing.last && crossing.last >= 0.0;
  return meets ? std::optional(crossing) : std::nullopt;
}

}  // namespace

RayApproach::RayApproach(const ConvexPolygon& polygon, const MapPoint& from, double bearing)
    : polygon_(&polygon), from_(from), bearing_(bearing) {
  if (const std::optional<Crossing> crossing = CrossingOf(polygon, from, bearing)) {
    along_ = std::max(0.0, crossing->first);
    return;
  }
  // A way that misses is nearest at a corner, or where it begins.
  distance_ = std::max(0.0, polygon.Outside(from));
  const MapLeg way{from, Project(from, {.bearing = bearing, .distance = 1.0})};
  for (const MapPoint& corner : polygon.corners()) {
    const double along = way.Along(corner);
    if (along <= 0.0) continue;
    const double distance =
        DistanceBetween(Project(from, {.bearing = bearing, .distance = along}), corner);
    if (distance < distance_) {
      distance_ = distance;
      along_ = along;
    }
  }
}

double RayApproach::Within(double length) const {
  // The distance falls until there and grows from there on: the polygon is convex.
  if (length >= along_) return distance_;
  return std::max(0.0,
                  polygon_->Outside(Project(from_, {.bearing = bearing_, .distance = length})));
}

std::optional<double> DistanceToBorder(const ConvexPolygon& polygon, const MapPoint& from,
                                       double bearing) {
  const std::optional<Crossing> crossing = CrossingOf(polygon, from, bearing);
  if (!crossing) return std::nullopt;
  return crossing->first >= 0.0 ? crossing->first : crossing->last;
}

std::vector<MapPoint> BufferedCorners(const ConvexPolygon& polygon, double distance) {
  constexpr double kFinest = std::numbers::pi / 6.0;
  const std::vector<MapPoint>& corners = polygon.corners();
  const std::size_t count = corners.size();
  std::vector<MapPoint> ring;
  for (std::size_t i = 0; i < count; ++i) {
    // Away from the edges to either side of the corner, which go round clockwise.
    const double before =
        BearingTo(corners[(i + count - 1) % count], corners[i]) - 0.5 * std::numbers::pi;
    const double after = BearingTo(corners[i], corners[(i + 1) % count]) - 0.5 * std::numbers::pi;
    const double turn = std::fmod(after - before + 4.0 * std::numbers::pi, 2.0 * std::numbers::pi);
    const int steps = std::max(1, static_cast<int>(std::ceil(turn / kFinest)));
    for (int k = 0; k <= steps; ++k) {
      ring.push_back(
          Project(corners[i], {.bearing = before + turn * k / steps, .distance = distance}));
    }
  }
  return ring;
}

}  // namespace limpet
