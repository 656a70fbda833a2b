// SPDX-License-Identifier: MIT
#include "limpet/figures/map_axes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/figures/rgba_png.hpp"
#include "limpet/figures/tick_marks.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr double kMapLeft = 58.0, kMapTop = 64.0, kMapBottom = 50.0, kMapGap = 24.0,
                 kLegendWidth = 212.0;
constexpr double kLargestMap = 620.0;  ///< longer side of the map [px]

RgbaImage::Pixel Opaque(const palette::Rgb& rgb) { return {rgb[0], rgb[1], rgb[2], 255}; }

double ScaleFor(double north_span, double east_span) {
  return kLargestMap / std::max({north_span, east_span, 1.0});
}

}  // namespace

MapAxes::MapAxes(const SurveyArea& area, const std::string& title, const std::string& subtitle)
    : north_min_(area.north_min - area.margin),
      north_max_(area.north_max + area.margin),
      east_min_(area.east_min - area.margin),
      east_max_(area.east_max + area.margin),
      scale_(ScaleFor(north_max_ - north_min_, east_max_ - east_min_)),
      canvas_({kMapLeft + (east_max_ - east_min_) * scale_ + kMapGap + kLegendWidth,
               kMapTop + std::max((north_max_ - north_min_) * scale_, 300.0) + kMapBottom},
              title),
      legend_y_(kMapTop + 6.0) {
  DrawFrame(title, subtitle);
}

Point MapAxes::At(const Eigen::Vector2d& p_W) const {
  return {kMapLeft + (p_W.y() - east_min_) * scale_, kMapTop + (north_max_ - p_W.x()) * scale_};
}

void MapAxes::DrawFrame(const std::string& title, const std::string& subtitle) {
  const Point corner = At({north_max_, east_min_});
  const Point size((east_max_ - east_min_) * scale_, (north_max_ - north_min_) * scale_);
  canvas_.Text({kMapLeft, 24.0}, title, {.size = 17.0, .is_bold = true});
  canvas_.Text({kMapLeft, 44.0}, subtitle, {.size = 12.5, .fill = palette::kMuted});
  canvas_.Rect(corner, size, {.fill = palette::kUnseen});
  const double bottom = corner.y() + size.y();
  for (const double east : TickMarks({east_min_, east_max_}, 9)) {
    const double x = At({0.0, east}).x();
    canvas_.Line({x, bottom}, {x, bottom + 5.0}, {.stroke = palette::kMuted});
    canvas_.Text({x, bottom + 19.0}, TickText(east), {.anchor = Anchor::kMiddle});
  }
  for (const double north : TickMarks({north_min_, north_max_}, 8)) {
    const double y = At({north, 0.0}).y();
    canvas_.Line({corner.x() - 5.0, y}, {corner.x(), y}, {.stroke = palette::kMuted});
    canvas_.Text({corner.x() - 9.0, y + 4.0}, TickText(north), {.anchor = Anchor::kEnd});
  }
  canvas_.Text({corner.x() + 0.5 * size.x(), bottom + 38.0}, "east [m]",
               {.anchor = Anchor::kMiddle, .fill = palette::kMuted});
  canvas_.Text({17.0, corner.y() + 0.5 * size.y()}, "north [m]",
               {.anchor = Anchor::kMiddle, .fill = palette::kMuted, .turn_deg = -90.0});
}

void MapAxes::Raster(const GridRecord& grid,
                     const std::function<palette::Rgb(const SeenCell&)>& color, double opacity) {
  const GridFrame& frame = grid.frame;
  if (frame.rows <= 0 || frame.columns <= 0) return;
  // Of an area too large for a pixel per cell, one cell of each square stands for it.
  constexpr int kMostPixels = 1600;
  const int step = 1 + (std::max(frame.rows, frame.columns) - 1) / kMostPixels;
  RgbaImage raster{(frame.columns + step - 1) / step, (frame.rows + step - 1) / step, {}};
  for (int line = raster.height - 1; line >= 0; --line) {  // a picture's lines start in the north
    for (int pixel = 0; pixel < raster.width; ++pixel) {
      const SeenCell& cell = grid.cells.At(line * step, pixel * step);
      raster.pixels.push_back(cell.is_in_sight() ? Opaque(color(cell)) : RgbaImage::Pixel{});
    }
  }
  const double pixel_m = step * frame.cell_m;
  const double north_max = frame.north_min + raster.height * pixel_m;
  canvas_.Image(At({north_max, frame.east_min}),
                Point(raster.width, raster.height) * pixel_m * scale_, Base64(EncodePng(raster)),
                opacity);
}

void MapAxes::Outline(const SurveyArea& area) {
  const Paint dashed{.stroke = palette::kMapMuted, .width = 1.0, .dash = "5 4"};
  const auto shape = SurveyShape::Of(area);
  if (!shape || shape->is_plain()) {
    canvas_.Rect(At({area.north_max, area.east_min}),
                 Point(area.east_max - area.east_min, area.north_max - area.north_min) * scale_,
                 dashed);
    return;
  }
  const auto draw = [this](const SimplePolygon& polygon, const Paint& paint) {
    std::vector<Point> corners;
    for (const PlanePoint& corner : polygon.corners()) {
      corners.push_back(At(corner));
    }
    canvas_.Polygon(corners, paint);
  };
  draw(shape->outline(), dashed);
  for (const SimplePolygon& zone : shape->zones()) {
    draw(zone, {.fill = palette::kMapMuted, .stroke = palette::kMapMuted, .opacity = 0.5});
  }
  if (shape->region()) draw(*shape->region(), {.stroke = palette::kMapMuted, .width = 0.7});
}

void MapAxes::BeginMap() {
  canvas_.BeginClip(At({north_max_, east_min_}),
                    Point(east_max_ - east_min_, north_max_ - north_min_) * scale_);
}

void MapAxes::EndMap() { canvas_.EndClip(); }

void MapAxes::ContinueLegendAt(double y) {
  constexpr double kBelow = 12.0;  // [px]
  legend_y_ = y;
  canvas_.GrowTo(legend_y_ + kBelow);
}

void MapAxes::Legend(const std::function<void(SvgCanvas&, const Point&)>& symbol,
                     const std::string& text) {
  const double x = At({0.0, east_max_}).x() + kMapGap;
  symbol(canvas_, {x + 12.0, legend_y_ + 6.0});
  std::size_t begin = 0;
  double y = legend_y_ + 10.0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    canvas_.Text({x + 34.0, y}, text.substr(begin, end - begin), {.size = 12.0});
    y += 15.0;
    begin = end + 1;
  }
  ContinueLegendAt(y - 2.0);
}

void MapAxes::LegendHeading(const std::string& text) {
  const double x = At({0.0, east_max_}).x() + kMapGap;
  legend_y_ += legend_y_ > kMapTop + 6.0 ? 14.0 : 0.0;
  canvas_.Text({x, legend_y_ + 8.0}, text,
               {.size = 12.0, .fill = palette::kMuted, .is_bold = true});
  ContinueLegendAt(legend_y_ + 20.0);
}

void MapAxes::ColorBar(const std::function<palette::Rgb(double)>& color, const std::string& low,
                       const std::string& high, const std::string& what) {
  LegendHeading(what);
  const double x = At({0.0, east_max_}).x() + kMapGap;
  constexpr int kSteps = 64;
  constexpr double kHeight = 150.0, kWidth = 16.0;
  RgbaImage bar{1, kSteps, {}};
  for (int i = 0; i < kSteps; ++i) {
    bar.pixels.push_back(Opaque(color(1.0 - (i + 0.5) / kSteps)));
  }
  canvas_.Image({x, legend_y_}, {kWidth, kHeight}, Base64(EncodePng(bar)));
  canvas_.Text({x + kWidth + 9.0, legend_y_ + 9.0}, high);
  canvas_.Text({x + kWidth + 9.0, legend_y_ + kHeight}, low);
  ContinueLegendAt(legend_y_ + kHeight + 8.0);
}

}  // namespace limpet
