// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limpet/figures/palette.hpp"
#include "limpet/figures/svg_canvas.hpp"
#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// A map seen from above: north up, east right, metres, the same scale both ways. Right of the map
/// is room for a legend.
class MapAxes {
 public:
  /// The frame covers the box around `area` and its margin. `title` says what one sees, `subtitle`
  /// how it was made.
  MapAxes(const SurveyArea& area, const std::string& title, const std::string& subtitle);

  [[nodiscard]] SvgCanvas::Point At(const Eigen::Vector2d& p_W) const;
  /// Right edge of the map [px].
  [[nodiscard]] double right() const { return At({0.0, east_max_}).x(); }
  [[nodiscard]] double pixels_per_metre() const { return scale_; }
  [[nodiscard]] SvgCanvas& canvas() { return canvas_; }

  /// Colours one pixel per cell of `grid` where it was seen; `color` gets the cell's index.
  void Raster(const GridRecord& grid, const std::function<palette::Rgb(const SeenCell&)>& color,
              double opacity = 1.0);
  /// The outline of the area to survey.
  void Outline(const SurveyArea& area);
  /// Everything between is cut to the map.
  void BeginMap();
  void EndMap();

  /// Draws the next line of the legend: `symbol` draws at the given centre, `text` explains. Long
  /// text is broken at '\n'.
  void Legend(const std::function<void(SvgCanvas&, const SvgCanvas::Point&)>& symbol,
              const std::string& text);
  void LegendHeading(const std::string& text);
  /// A vertical colour scale in the legend with its range in text.
  void ColorBar(const std::function<palette::Rgb(double)>& color, const std::string& low,
                const std::string& high, const std::string& what);

  [[nodiscard]] std::string Finish() const { return canvas_.Finish(); }

 private:
  void DrawFrame(const std::string& title, const std::string& subtitle);
  /// The next line of the legend begins there; the picture grows with a legend longer than the map
  /// is high.
  void ContinueLegendAt(double y);
  double north_min_, north_max_, east_min_, east_max_;
  double scale_;
  SvgCanvas canvas_;
  double legend_y_;
};

/// Points to draw for a curve: those farther than `tolerance` from the straight line between others
/// (Douglas and Peucker).
[[nodiscard]] std::vector<SvgCanvas::Point> Simplified(const std::vector<SvgCanvas::Point>& points,
                                                       double tolerance);

}  // namespace limpet
