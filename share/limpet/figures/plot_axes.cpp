// SPDX-License-Identifier: MIT
#include "limpet/figures/plot_axes.hpp"

#include <algorithm>

#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/palette.hpp"
#include "limpet/figures/tick_marks.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

}  // namespace

PlotAxes::PlotAxes(SvgCanvas& canvas, const Layout& layout) : canvas_(canvas), layout_(layout) {
  const Point& corner = layout.corner;
  const double right = corner.x() + layout.size.x();
  const double bottom = corner.y() + layout.size.y();
  for (const double y : TickMarks(layout.y, layout.y_ticks)) {
    const double at = At({layout.x.low, y}).y();
    canvas.Line({corner.x(), at}, {right, at}, {.stroke = palette::kGrid});
    canvas.Text({corner.x() - 8.0, at + 4.0}, TickText(y), {.anchor = Anchor::kEnd});
  }
  for (const double x : TickMarks(layout.x, 9)) {
    const double at = At({x, layout.y.low}).x();
    canvas.Line({at, bottom}, {at, bottom + 5.0}, {.stroke = palette::kMuted});
    if (layout.has_x_labels) {
      canvas.Text({at, bottom + 19.0}, TickText(x), {.anchor = Anchor::kMiddle});
    }
  }
  canvas.Line({corner.x(), bottom}, {right, bottom}, {.stroke = palette::kMuted});
  if (layout.has_x_labels) {
    canvas.Text({corner.x() + 0.5 * layout.size.x(), bottom + 38.0}, layout.x_label,
                {.anchor = Anchor::kMiddle, .fill = palette::kMuted});
  }
  canvas.Text({corner.x() - 54.0, corner.y() + 0.5 * layout.size.y()}, layout.y_label,
              {.anchor = Anchor::kMiddle, .fill = palette::kMuted, .turn_deg = -90.0});
}

Point PlotAxes::At(const Point& value) const {
  const double fx = (value.x() - layout_.x.low) / (layout_.x.high - layout_.x.low);
  const double fy = (value.y() - layout_.y.low) / (layout_.y.high - layout_.y.low);
  return {layout_.corner.x() + fx * layout_.size.x(),
          layout_.corner.y() + (1.0 - fy) * layout_.size.y()};
}

void PlotAxes::Curve(const std::vector<double>& x, const std::vector<double>& y,
                     const Paint& paint) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
    points.push_back(At({x[i], y[i]}));
  canvas_.BeginClip(layout_.corner, layout_.size);
  canvas_.Polyline(Simplified(points, 0.25), paint);
  canvas_.EndClip();
}

void PlotAxes::Band(const std::vector<double>& x, const std::vector<double>& low,
                    const std::vector<double>& high, const Paint& paint) {
  std::vector<Point> upper, lower;
  for (std::size_t i = 0; i < x.size(); ++i) {
    upper.push_back(At({x[i], high[i]}));
    lower.push_back(At({x[i], low[i]}));
  }
  upper = Simplified(upper, 0.25);
  lower = Simplified(lower, 0.25);
  upper.insert(upper.end(), lower.rbegin(), lower.rend());
  canvas_.BeginClip(layout_.corner, layout_.size);
  canvas_.Polygon(upper, paint);
  canvas_.EndClip();
}

void PlotAxes::Level(double y, const Paint& paint) {
  canvas_.Line(At({layout_.x.low, y}), At({layout_.x.high, y}), paint);
}

void DrawKey(SvgCanvas& canvas, const Point& at, const std::string& text, const Paint& paint) {
  canvas.Line(at, at + Point(26.0, 0.0), paint);
  canvas.Text(at + Point(33.0, 4.0), text);
}

}  // namespace limpet
