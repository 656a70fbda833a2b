// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/shapes/shape.hpp"
#include "limpet/shapes/visual_hints.hpp"

namespace limpet {

/// A shape's variable and text, and what tells it apart from others of that variable.
struct DrawnText {
  std::string variable, text, key;
};

/// What viewers draw of a way: its points, the next one, and the one steered for. Colors and sizes
/// are the hints'; erasing gives the same shapes, inactive.
struct WayDrawing {
  std::string vehicle, behavior;
  const VisualHints& hints;

  [[nodiscard]] std::vector<DrawnText> Draw(const std::vector<MapPoint>& points,
                                            const MapPoint& next, const MapPoint& steering) const;
  [[nodiscard]] std::vector<DrawnText> Erase(const std::vector<MapPoint>& points,
                                             const MapPoint& next) const;
};

/// What viewers draw of a polygon that is gone round, with the colors and sizes of the hints.
struct RingDrawing {
  std::string vehicle, behavior;
  const VisualHints& hints;

  [[nodiscard]] std::vector<DrawnText> Draw(const std::vector<MapPoint>& corners,
                                            const MapPoint& next, bool is_active) const;
};

/// Circles round one point, as polygons of 32 corners.
struct CircleDrawing {
  MapPoint center;
  const VisualHints& hints;

  [[nodiscard]] std::vector<DrawnText> Draw(const std::string& label, double radius,
                                            bool is_active) const;
};

/// The text of a shape that is drawn.
[[nodiscard]] DrawnText DrawnTextOf(const Shape& shape, std::string key = "");

}  // namespace limpet
