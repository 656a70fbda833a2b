// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/shapes/shape.hpp"

namespace limpet {

/// A convex polygon on the map, its corners in clockwise order.
class ConvexPolygon {
 public:
  /// Nothing unless there are at least three corners that enclose an area and turn one way; corners
  /// on a straight edge are allowed. Counter-clockwise ones are turned round.
  [[nodiscard]] static std::optional<ConvexPolygon> Of(std::vector<MapPoint> corners);

  [[nodiscard]] const std::vector<MapPoint>& corners() const { return corners_; }
  [[nodiscard]] bool Contains(const MapPoint& at) const;
  /// Distance to the nearest edge [m]; negative inside.
  [[nodiscard]] double Outside(const MapPoint& at) const;
  /// The point of its border that is nearest.
  [[nodiscard]] MapPoint NearestOnBorder(const MapPoint& at) const;
  /// Middle of the box around it.
  [[nodiscard]] MapPoint Center() const;
  /// Distance from the center to the farthest corner [m].
  [[nodiscard]] double Radius() const;
  void MoveTo(const MapPoint& center);
  /// Every corner further from the center by `distance` [m], or nearer, but no nearer than a metre.
  void Grow(double distance);
  /// True if the straight line from outside to the corner of this index meets nothing of it.
  [[nodiscard]] bool Shows(std::size_t corner, const MapPoint& from) const;

 private:
  explicit ConvexPolygon(std::vector<MapPoint> corners) : corners_(std::move(corners)) {}
  std::vector<MapPoint> corners_;
};

}  // namespace limpet
