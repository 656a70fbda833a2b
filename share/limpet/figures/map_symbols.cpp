// SPDX-License-Identifier: MIT
#include "limpet/figures/map_symbols.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/objects/status_color.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

}  // namespace

void DrawTriangle(SvgCanvas& canvas, const Point& centre, double radius, Radians turn,
                  const Paint& paint) {
  std::vector<Point> corners;
  for (int k = 0; k < 3; ++k) {
    const double angle = turn.value() + 2.0 * std::numbers::pi * k / 3.0;
    corners.emplace_back(centre + radius * Point(std::sin(angle), -std::cos(angle)));
  }
  canvas.Polygon(corners, paint);
}

void DrawCross(SvgCanvas& canvas, const Point& centre, double radius, const Paint& paint) {
  canvas.Line(centre - Point(radius, radius), centre + Point(radius, radius), paint);
  canvas.Line(centre - Point(radius, -radius), centre + Point(radius, -radius), paint);
}

void DrawStatus(SvgCanvas& canvas, const Point& centre, Status status, double radius) {
  const std::optional<StatusColor> decided = ColorOf(status);
  const std::string_view color = decided ? decided->hex : palette::kMapMuted;
  const Paint solid{.fill = color, .stroke = palette::kHalo, .width = 1.5};
  if (status == Status::kConfirmed) {
    canvas.Circle(centre, radius, solid);
  } else if (status == Status::kRemoved) {
    DrawCross(canvas, centre, 0.85 * radius, {.stroke = palette::kHalo, .width = 6.5});
    DrawCross(canvas, centre, 0.85 * radius, {.stroke = color, .width = 3.5});
  } else if (status == Status::kNew) {
    DrawTriangle(canvas, centre + Point(0.0, 0.15 * radius), 1.3 * radius, Radians(0.0), solid);
  } else if (status == Status::kMoved) {
    canvas.Polygon({centre + Point(0.0, -1.2 * radius), centre + Point(1.2 * radius, 0.0),
                    centre + Point(0.0, 1.2 * radius), centre + Point(-1.2 * radius, 0.0)},
                   solid);
  } else {
    canvas.Rect(centre - Point(radius, radius) * 0.85, Point(radius, radius) * 1.7,
                {.fill = palette::kHalo, .stroke = color, .width = 2.0});
    if (status == Status::kNotInspected) {
      const Point half = Point(radius, -radius) * 0.85;
      canvas.Line(centre - half, centre + half, {.stroke = color, .width = 2.0});
    }
  }
}

void DrawTruth(MapAxes& map, const Eigen::Vector3d& p_W, double radius_m) {
  map.canvas().Circle(map.At(p_W.head<2>()), radius_m * map.pixels_per_metre(),
                      {.stroke = palette::kMapInk, .width = 1.4});
}

void DrawCovariance(SvgCanvas& canvas, const Point& centre, double scale,
                    const std::array<double, 3>& cov, const Paint& paint) {
  const auto [nn, ne, ee] = cov;
  const double mean = 0.5 * (nn + ee);
  const double spread = std::hypot(0.5 * (nn - ee), ne);
  const double major = std::sqrt(std::max(mean + spread, 0.0));
  const double minor = std::sqrt(std::max(mean - spread, 0.0));
  const double bearing = 0.5 * std::atan2(2.0 * ne, nn - ee);  // of the major axis, from north
  canvas.Ellipse(centre, {major * scale, minor * scale}, DegreesFromRadians(bearing) - 90.0, paint);
}

void DrawLabel(MapAxes& map, const Eigen::Vector3d& p_W, const PlaceLabel& label) {
  constexpr double kLine = 15.0, kLetter = 6.6;
  std::size_t longest = 0;
  for (const std::string& line : label.lines)
    longest = std::max(longest, line.size());
  Point at = map.At(p_W.head<2>());
  const bool is_left =
      at.x() + label.distance + kLetter * static_cast<double>(longest) > map.right();
  at += Point(is_left ? -label.distance : label.distance, -5.0);
  for (std::size_t i = 0; i < label.lines.size(); ++i) {
    map.canvas().Text(at + Point(0.0, kLine * static_cast<double>(i)), label.lines[i],
                      {.size = i == 0 ? 13.0 : 12.0,
                       .anchor = is_left ? Anchor::kEnd : Anchor::kStart,
                       .fill = label.fill,
                       .is_bold = i == 0,
                       .has_halo = true});
  }
}

void DrawHome(SvgCanvas& canvas, const Point& centre) {
  canvas.Polygon({centre + Point(-7.0, 0.5), centre + Point(0.0, -7.5), centre + Point(7.0, 0.5),
                  centre + Point(7.0, 7.0), centre + Point(-7.0, 7.0)},
                 {.fill = palette::kMapInk, .stroke = palette::kHalo, .width = 1.5});
}

}  // namespace limpet
