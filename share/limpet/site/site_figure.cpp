// SPDX-License-Identifier: MIT
#include "limpet/site/site_figure.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "limpet/figures/map_axes.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {
namespace {

/// What lies `margin` beyond the area, where the vehicle may be if no region is said: its border in
/// pieces, since where two sides face each other it has none.
std::vector<std::vector<PlanePoint>> BorderBeyond(const SimplePolygon& outline, double margin) {
  constexpr double kTurn = 0.1;    // between two points around a corner [rad]
  constexpr double kTouch = 1e-6;  // [m]
  constexpr double kFinest = 1.0 / 64;
  std::vector<std::vector<PlanePoint>> pieces(1);
  const auto take = [&](const PlanePoint& at) {
    if (-outline.Depth(at) >= margin - kTouch) {
      pieces.back().push_back(at);
    } else if (!pieces.back().empty()) {
      pieces.emplace_back();
    }
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlaneEdge edge = outline.Edge(i);
    const PlanePoint along = edge.to_W - edge.from_W;
    PlanePoint off = PlanePoint(-along.y(), along.x()).normalized() * margin;
    const PlanePoint middle = edge.from_W + 0.5 * along;
    const bool is_inward = outline.Contains(middle + 1e-3 * off.normalized());
    if (is_inward) off = -off;
    for (double share = 0.0; share <= 1.0; share += kFinest)
      take(edge.from_W + share * along + off);
    // Around the corner; where the next side begins sooner, those places are not of the border.
    const double turn = is_inward ? kTurn : -kTurn;
    for (double angle = turn; std::abs(angle) < std::numbers::pi; angle += turn) {
      const PlanePoint around(off.x() * std::cos(angle) - off.y() * std::sin(angle),
                              off.x() * std::sin(angle) + off.y() * std::cos(angle));
      const PlanePoint at = edge.to_W + around;
      if (-outline.Depth(at) < margin - kTouch) break;
      take(at);
    }
  }
  return pieces;
}

/// What MapAxes leaves out: the region, if the mission does not say it.
void DrawRegion(const Site& site, MapAxes& map) {
  const SurveyShape shape = *SurveyShape::Of(site.area);
  if (shape.region() || shape.margin() <= 0.0) return;
  const Paint thin{.stroke = palette::kMapMuted, .width = 0.7};
  const auto draw = [&](const std::vector<PlanePoint>& border) {
    std::vector<SvgCanvas::Point> line;
    for (const PlanePoint& at : border)
      line.push_back(map.At(at));
    if (line.size() > 1) map.canvas().Polyline(line, thin);
  };
  if (shape.is_plain()) {
    const Region region(site.area);
    const double south = region.north_min(), north = region.north_max();
    const double west = region.east_min(), east = region.east_max();
    draw({{south, west}, {north, west}, {north, east}, {south, east}, {south, west}});
    return;
  }
  for (const std::vector<PlanePoint>& piece : BorderBeyond(shape.outline(), shape.margin()))
    draw(piece);
}

/// A line of the legend that is a piece of line.
void LineLegend(MapAxes& map, const Paint& paint, const std::string& text) {
  map.Legend(
      [paint](SvgCanvas& canvas, const SvgCanvas::Point& at) {
        canvas.Line(at - SvgCanvas::Point(10.0, 0.0), at + SvgCanvas::Point(10.0, 0.0), paint);
      },
      text);
}

/// Draws the legend: of what is drawn, and of nothing else.
void DrawLegend(const Site& site, MapAxes& map) {
  const SurveyShape shape = *SurveyShape::Of(site.area);
  LineLegend(map, {.stroke = palette::kMapMuted, .width = 1.0, .dash = "5 4"}, "area to survey");
  if (shape.region() || shape.margin() > 0.0) {
    LineLegend(map, {.stroke = palette::kMapMuted, .width = 0.7}, "operating region");
  }
  if (ZonesBeyond(site) < std::ssize(shape.zones())) {
    map.Legend(
        [](SvgCanvas& canvas, const SvgCanvas::Point& at) {
          canvas.Rect(at - SvgCanvas::Point(8.0, 5.0), {16.0, 10.0},
                      {.fill = palette::kMapMuted, .opacity = 0.5});
        },
        "keep-out zone");
  }
  if (!shape.transit().empty()) {
    LineLegend(map, {.stroke = palette::kBlue, .width = 1.5}, "transit");
  }
  if (site.start_W) {
    map.Legend(
        [](SvgCanvas& canvas, const SvgCanvas::Point& at) {
          canvas.Circle(at, 5.0, {.fill = palette::kVermillion});
        },
        "start and home");
  }
}

}  // namespace

std::string SiteSvg(const Site& site) {
  const Region region(site.area);
  const SiteBox box = BoxAround(site);
  const SurveyArea frame{.north_min = box.low_W.x(),
                         .north_max = box.high_W.x(),
                         .east_min = box.low_W.y(),
                         .east_max = box.high_W.y(),
                         .margin = box.room()};
  MapAxes map(frame, "What " + site.name + " surveys", site.Summary());
  map.BeginMap();
  map.Outline(site.area);
  DrawRegion(site, map);
  std::vector<SvgCanvas::Point> way;
  if (site.start_W) way.push_back(map.At(*site.start_W));
  for (const PlanePoint& at : region.transit())
    way.push_back(map.At(at));
  if (way.size() > 1) map.canvas().Polyline(way, {.stroke = palette::kBlue, .width = 1.5});
  if (site.start_W) {
    map.canvas().Circle(way.front(), 5.0, {.fill = palette::kVermillion});
  }
  map.EndMap();
  DrawLegend(site, map);
  return map.Finish();
}

}  // namespace limpet
