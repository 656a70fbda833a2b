// SPDX-License-Identifier: MIT
// What operator displays draw: shapes as the text of VIEW_* variables. Coordinates are MOOS's, x
// east and y north of the datum [m]; this is the border where NED ends.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// A place on the viewer's map [m].
struct MapPoint {
  double x = 0.0;  ///< east
  double y = 0.0;  ///< north
  bool operator==(const MapPoint&) const = default;
};
[[nodiscard]] inline MapPoint MapPointOf(const Eigen::Vector2d& p_W) {
  return {.x = p_W.y(), .y = p_W.x()};
}

struct PointShape {
  MapPoint at;
  bool operator==(const PointShape&) const = default;
};
struct SeglistShape {
  std::vector<MapPoint> points;
  bool operator==(const SeglistShape&) const = default;
};
/// Must be convex: viewers refuse others.
struct PolygonShape {
  std::vector<MapPoint> corners;
  bool operator==(const PolygonShape&) const = default;
};
struct CircleShape {
  MapPoint center;
  double radius = 0.0;
  bool operator==(const CircleShape&) const = default;
};
struct MarkerShape {
  MapPoint at;
  double width = 1.0;
  std::string type = "circle";  ///< circle, square, diamond, efield, gateway or triangle
  std::string primary_color{}, secondary_color{};
  bool operator==(const MarkerShape&) const = default;
};

/// How it is drawn. Colors are X11's names with underscores (dodger_blue); empty: the viewer's
/// choice; `invisible`: not drawn.
struct ShapeStyle {
  std::string msg{};  ///< shown in place of the label
  std::string label_color{}, edge_color{}, vertex_color{}, fill_color{};
  std::optional<double> vertex_size{}, edge_size{};
  std::optional<double> fill_transparency{};  ///< 0 to 1
  bool operator==(const ShapeStyle&) const = default;
};

struct Shape {
  std::string label;  ///< a later shape of the same kind, label and source replaces this one
  std::variant<PointShape, SeglistShape, PolygonShape, CircleShape, MarkerShape> form;
  ShapeStyle style{};
  bool is_active = true;  ///< false erases
  bool operator==(const Shape&) const = default;
};

/// VIEW_POINT, VIEW_SEGLIST, VIEW_POLYGON, VIEW_CIRCLE or VIEW_MARKER.
[[nodiscard]] std::string_view VariableOf(const Shape& shape);

/// Points, circles and markers to 0.01 m, seglists and polygons to 0.1 m. Characters that would end
/// a field are replaced by `_`.
[[nodiscard]] std::string EncodeShape(const Shape& shape);

/// Reads what EncodeShape writes, and what viewers accept of it in any order of fields; unknown
/// fields are left out. Nothing without a complete geometry.
[[nodiscard]] std::optional<Shape> DecodeShape(std::string_view variable, std::string_view text);

}  // namespace limpet
