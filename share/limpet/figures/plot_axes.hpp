// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/interval.hpp"
#include "limpet/figures/svg_canvas.hpp"

namespace limpet {

/// One panel of a line plot: a frame in a canvas with a linear scale on each axis.
class PlotAxes {
 public:
  struct Layout {
    SvgCanvas::Point corner{58.0, 64.0};  ///< upper left of the frame [px]
    SvgCanvas::Point size{560.0, 300.0};
    Interval x{0.0, 1.0}, y{0.0, 1.0};
    std::string x_label, y_label;
    bool has_x_labels = true;
    int y_ticks = 6;
  };
  PlotAxes(SvgCanvas& canvas, const Layout& layout);

  [[nodiscard]] SvgCanvas::Point At(const SvgCanvas::Point& value) const;
  /// A curve, cut to the frame and thinned to what can be seen.
  void Curve(const std::vector<double>& x, const std::vector<double>& y, const Paint& paint);
  /// The area between two curves over the same x.
  void Band(const std::vector<double>& x, const std::vector<double>& low,
            const std::vector<double>& high, const Paint& paint);
  /// A horizontal line across the frame.
  void Level(double y, const Paint& paint);

 private:
  SvgCanvas& canvas_;
  Layout layout_;
};

/// A line of a plot's key: how it is drawn, and what it means.
void DrawKey(SvgCanvas& canvas, const SvgCanvas::Point& at, const std::string& text,
             const Paint& paint);

}  // namespace limpet
