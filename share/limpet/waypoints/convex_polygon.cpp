// SPDX-License-Identifier: MIT
#include "limpet/waypoints/convex_polygon.hpp"

#include <algorithm>
#include <limits>

#include "limpet/waypoints/left_of.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

const MapPoint& Next(const std::vector<MapPoint>& corners, std::size_t i) {
  return corners[(i + 1) % corners.size()];
}

}  // namespace

std::optional<ConvexPolygon> ConvexPolygon::Of(std::vector<MapPoint> corners) {
  constexpr std::size_t kFewest = 3;
  if (corners.size() < kFewest) {
    return std::nullopt;
  }
  double area = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area += 0.5 * LeftOf(corners[0], corners[i], corners[i + 1]);
  }
  if (area == 0.0) {
    return std::nullopt;
  }
  if (area > 0.0) {
    std::ranges::reverse(corners);
  }
  for (const MapPoint& corner : corners) {  // of a star, some corner lies beyond some edge
    for (std::size_t i = 0; i < corners.size(); ++i) {
      constexpr double kRounding = 1e-6;  // [m^2]
      if (LeftOf(corners[i], Next(corners, i), corner) > kRounding) {
        return std::nullopt;
      }
    }
  }
  return ConvexPolygon(std::move(corners));
}

bool ConvexPolygon::Contains(const MapPoint& at) const {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (LeftOf(corners_[i], Next(corners_, i), at) > 0.0) {
      return false;
    }
  }
  return true;
}

MapPoint ConvexPolygon::NearestOnBorder(const MapPoint& at) const {
  MapPoint nearest = corners_.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const MapLeg edge{.from = corners_[i], .to = Next(corners_, i)};
    const MapPoint point = edge.At(std::clamp(edge.Along(at), 0.0, edge.length()));
    if (const double distance = DistanceBetween(at, point); distance < least) {
      least = distance;
      nearest = point;
    }
  }
  return nearest;
}

double ConvexPolygon::Outside(const MapPoint& at) const {
  const double distance = DistanceBetween(at, NearestOnBorder(at));
  return Contains(at) ? -distance : distance;
}

MapPoint ConvexPolygon::Center() const {
  const auto [west, east] = std::ranges::minmax(corners_, {}, &MapPoint::x);
  const auto [south, north] = std::ranges::minmax(corners_, {}, &MapPoint::y);
  return {.x = 0.5 * (west.x + east.x), .y = 0.5 * (south.y + north.y)};
}

double ConvexPolygon::Radius() const {
  const MapPoint center = Center();
  double radius = 0.0;
  for (const MapPoint& corner : corners_) {
    radius = std::max(radius, DistanceBetween(center, corner));
  }
  return radius;
}

void ConvexPolygon::MoveTo(const MapPoint& center) {
  const MapPoint old = Center();
  for (MapPoint& corner : corners_) {
    corner.x += center.x - old.x;
    corner.y += center.y - old.y;
  }
}

void ConvexPolygon::Grow(double distance) {
  constexpr double kLeast = 1.0;  // [m]
  const MapPoint center = Center();
  for (MapPoint& corner : corners_) {
    const double radius = std::max(DistanceBetween(center, corner) + distance, kLeast);
    corner = Project(center, {.bearing = BearingTo(center, corner), .distance = radius});
  }
}

bool ConvexPolygon::Shows(std::size_t corner, const MapPoint& from) const {
  const MapPoint& here = corners_[corner];
  const MapPoint& before = corners_[(corner + corners_.size() - 1) % corners_.size()];
  return LeftOf(before, here, from) > 0.0 || LeftOf(here, Next(corners_, corner), from) > 0.0;
}

}  // namespace limpet
