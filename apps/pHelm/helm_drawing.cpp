// SPDX-License-Identifier: MIT
#include "apps/pHelm/helm_drawing.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/helm/path_chords.hpp"

namespace limpet {
namespace {

constexpr double kSagitta = 0.02;  ///< [m] of a drawn chord

PolygonShape Rectangle(const SurveyArea& area, double margin) {
  const double north = area.north_max + margin, south = area.north_min - margin;
  const double east = area.east_max + margin, west = area.east_min - margin;
  return {{MapPointOf({south, west}), MapPointOf({south, east}), MapPointOf({north, east}),
           MapPointOf({north, west})}};
}

Shape OptionEnd(std::string label, const BiddenOption& option) {
  return {.label = std::move(label),
          .form = PointShape{MapPointOf({option.end[0], option.end[1]})},
          .style = {.msg = fmt::format("{} {:.1f}", option.source, option.total),
                    .label_color = "gray50",
                    .vertex_color = "gray50",
                    .vertex_size = 3.0}};
}

}  // namespace

HelmDrawing::HelmDrawing(std::string vehicle, ShapeBoard::Post post)
    : vehicle_(std::move(vehicle)), board_(std::move(post)) {}

std::string HelmDrawing::Label(const std::string& what) const {
  return vehicle_.empty() ? what : vehicle_ + "_" + what;
}

void HelmDrawing::DrawShape(const SurveyShape& shape) {
  DrawRing("area", shape.outline(), "yellow");
  if (shape.region()) DrawRing("region", *shape.region(), "gray50");
  int zone = 0;
  for (const SimplePolygon& polygon : shape.zones()) {
    DrawRing(fmt::format("keep_out_{}", ++zone), polygon, "red");
  }
}

/// Draws a polygon as a closed line: viewers refuse polygons that are not convex.
void HelmDrawing::DrawRing(const std::string& what, const SimplePolygon& polygon,
                           const std::string& color) {
  SeglistShape ring;
  for (const PlanePoint& corner : polygon.corners()) {
    ring.points.push_back(MapPointOf(corner));
  }
  ring.points.push_back(ring.points.front());
  board_.Draw({.label = Label(what),
               .form = ring,
               .style = {.label_color = color,
                         .edge_color = color,
                         .vertex_color = "invisible",
                         .edge_size = 1.0}});
}

void HelmDrawing::DrawArea(const SurveyArea& area) {
  if (const auto shape = SurveyShape::Of(area); shape && !shape->is_plain()) {
    DrawShape(*shape);
    return;
  }
  board_.Draw({.label = Label("area"),
               .form = Rectangle(area, 0.0),
               .style = {.label_color = "yellow",
                         .edge_color = "yellow",
                         .vertex_color = "invisible",
                         .edge_size = 1.0}});
  board_.Draw({.label = Label("region"),
               .form = Rectangle(area, area.margin),
               .style = {.label_color = "invisible",
                         .edge_color = "gray50",
                         .vertex_color = "invisible",
                         .edge_size = 1.0}});
}

void HelmDrawing::DrawHome(const HomePoint& home) {
  board_.Draw(
      {.label = Label("home"),
       .form = PointShape{MapPointOf({home.north, home.east})},
       .style = {
           .msg = "home", .label_color = "green", .vertex_color = "green", .vertex_size = 5.0}});
}

void HelmDrawing::DrawDecision(const ViewDecision& decision) {
  has_path_ = true;
  const Option& chosen = *decision.chosen;
  board_.Draw({.label = Label("path"),
               .form = SeglistShape{MapPointsOf(chosen.path, kSagitta)},
               .style = {.msg = fmt::format("{} {:.0f} m", chosen.source, chosen.path.length()),
                         .label_color = "white",
                         .edge_color = "white",
                         .vertex_color = "invisible",
                         .edge_size = 2.0}});
  std::vector<Shape> others;
  constexpr std::size_t kShown = 5;
  for (std::size_t i = 1; i < std::min(decision.bids.options.size(), kShown); ++i) {
    others.push_back(OptionEnd(Label(fmt::format("option_{}", i)), decision.bids.options[i]));
  }
  board_.Replace(Label("option_"), others);
}

void HelmDrawing::ErasePath() {
  if (has_path_) {
    has_path_ = false;
    board_.Replace(Label("path"), {});
    board_.Replace(Label("option_"), {});
  }
}

}  // namespace limpet
