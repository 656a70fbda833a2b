// SPDX-License-Identifier: MIT
#include "limpet/waypoints/way_drawing.hpp"

#include <numbers>
#include <utility>

#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

constexpr double kShownLead = 5.0;  ///< nearer to the next point, the steered one is not drawn [m]

}  // namespace

DrawnText DrawnTextOf(const Shape& shape, std::string key) {
  return {.variable = std::string(VariableOf(shape)),
          .text = EncodeShape(shape),
          .key = std::move(key)};
}

std::vector<DrawnText> WayDrawing::Draw(const std::vector<MapPoint>& points, const MapPoint& next,
                                        const MapPoint& steering) const {
  Shape way{.label = vehicle + "_" + behavior,
            .form = SeglistShape{points},
            .style = {.label_color = hints.Text("label_color", "white"),
                      .edge_color = hints.Text("edge_color", "white"),
                      .vertex_color = hints.Text("vertex_color", "dodger_blue"),
                      .vertex_size = hints.Number("vertex_size", 3.0),
                      .edge_size = hints.Number("edge_size", 1.0)}};
  way.is_active = way.style.edge_color != "off" && way.style.edge_color != "inactive";
  const std::string color = hints.Text("nextpt_color", "yellow");
  const Shape target{.label = vehicle + "'s nextpt",
                     .form = PointShape{next},
                     .style = {.label_color = hints.Text("nextpt_label_color", "aqua"),
                               .vertex_color = color,
                               .vertex_size = hints.Number("nextpt_vertex_size", 5.0)}};
  const Shape track{.label = vehicle + "'s trackpt",
                    .form = PointShape{steering},
                    .style = {.label_color = color, .vertex_color = color, .vertex_size = 4.0},
                    .is_active = DistanceBetween(steering, next) > kShownLead};
  return {DrawnTextOf(way), DrawnTextOf(target, "wpt"), DrawnTextOf(track, "trk")};
}

std::vector<DrawnText> WayDrawing::Erase(const std::vector<MapPoint>& points,
                                         const MapPoint& next) const {
  const auto point = [&](const char* what) {
    return Shape{.label = vehicle + what, .form = PointShape{next}, .is_active = false};
  };
  const Shape way{
      .label = vehicle + "_" + behavior, .form = SeglistShape{points}, .is_active = false};
  return {DrawnTextOf(point("'s trackpt"), "trk"), DrawnTextOf(point("'s nextpt"), "wpt"),
          DrawnTextOf(way)};
}

std::vector<DrawnText> RingDrawing::Draw(const std::vector<MapPoint>& corners, const MapPoint& next,
                                         bool is_active) const {
  const Shape ring{.label = hints.Text("label", vehicle + "_" + behavior),
                   .form = PolygonShape{corners},
                   .style = {.label_color = hints.Text("label_color", ""),
                             .edge_color = hints.Text("edge_color", "white"),
                             .vertex_color = hints.Text("vertex_color", "dodger_blue"),
                             .vertex_size = hints.Number("vertex_size", 1.0),
                             .edge_size = hints.Number("edge_size", 1.0)},
                   .is_active = is_active};
  const Shape target{.label = vehicle + "_waypoint",
                     .form = PointShape{next},
                     .style = {.label_color = hints.Text("nextpt_label_color", "aqua"),
                               .vertex_color = hints.Text("nextpt_color", "yellow"),
                               .vertex_size = hints.Number("nextpt_vertex_size", 5.0)},
                     .is_active = is_active};
  return {DrawnTextOf(ring), DrawnTextOf(target)};
}

std::vector<DrawnText> CircleDrawing::Draw(const std::string& label, double radius,
                                           bool is_active) const {
  constexpr int kCorners = 32;
  PolygonShape circle;
  for (int i = 0; i < kCorners; ++i) {
    circle.corners.push_back(
        Project(center, {.bearing = 2.0 * std::numbers::pi * i / kCorners, .distance = radius}));
  }
  const Shape shape{.label = label,
                    .form = std::move(circle),
                    .style = {.label_color = hints.Text("label_color", "white"),
                              .edge_color = hints.Text("edge_color", "light_blue"),
                              .vertex_color = hints.Text("vertex_color", "red"),
                              .vertex_size = hints.Number("vertex_size", 1.0),
                              .edge_size = hints.Number("edge_size", 1.0)},
                    .is_active = is_active};
  return {DrawnTextOf(shape, label)};
}

}  // namespace limpet
