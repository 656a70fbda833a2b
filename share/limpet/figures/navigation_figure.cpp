// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/figures/chart_layout.hpp"
#include "limpet/figures/figures.hpp"
#include "limpet/figures/palette.hpp"
#include "limpet/figures/plot_axes.hpp"
#include "limpet/figures/probability_text.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr Paint kEstimate{.stroke = palette::kBlue, .width = 1.8};
constexpr Paint kDeadReckoning{.stroke = palette::kVermillion, .width = 1.8, .dash = "6 4"};

double Largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

std::vector<double> Minutes(const std::vector<double>& seconds) {
  std::vector<double> out;
  for (const double t : seconds)
    out.push_back(t / 60.0);
  return out;
}

/// One of the charts below each other: a position axis, its error and the estimator's bound [m].
struct ErrorPanel {
  double top_px = 0.0;
  const char* label;
  const std::vector<double>& error;
  const std::vector<double>& sd;
  bool is_last = false;
};

/// Error of one axis over its own 3-sigma bounds.
void DrawAxis(SvgCanvas& canvas, const ErrorPanel& panel, const std::vector<double>& minutes,
              double minutes_high) {
  const std::vector<double>&error = panel.error, &sd = panel.sd;
  std::vector<double> low, high;
  double largest = 0.05;
  for (std::size_t i = 0; i < sd.size(); ++i) {
    high.push_back(3.0 * sd[i]);
    low.push_back(-3.0 * sd[i]);
    largest = std::max(largest, std::abs(error[i]));
  }
  // The bounds are wide before the first looks at an object; the errors must stay legible.
  std::vector<double> sorted = high;
  std::sort(sorted.begin(), sorted.end());
  if (!sorted.empty())
    largest = std::max(largest, std::min(sorted[sorted.size() * 9 / 10], 6.0 * largest));
  largest *= 1.1;
  PlotAxes axes(canvas, {.corner = {chart::kLeft, panel.top_px},
                         .size = {chart::kWidth, 84.0},
                         .x = {0.0, minutes_high},
                         .y = {-largest, largest},
                         .x_label = "time since the survey began [min]",
                         .y_label = panel.label,
                         .has_x_labels = panel.is_last,
                         .y_ticks = 4});
  axes.Band(minutes, low, high, chart::kBounds);
  axes.Level(0.0, {.stroke = palette::kMuted, .width = 0.8});
  axes.Curve(minutes, error, {.stroke = palette::kBlue, .width = 1.3});
}

}  // namespace

Figure NavigationFigure(const FigureSource& source) {
  const NavScore& nav = source.score.nav;
  const NavErrorCurve& curve = nav.curve;
  SvgCanvas canvas({chart::kLeft + chart::kWidth + 24.0, 636.0}, "Navigation error");
  canvas.Text({chart::kLeft, 24.0},
              fmt::format("Position error {} rms; at the end {}, dead reckoning {}",
                          MetresText(nav.position_rmse_m), MetresText(nav.final_error_m),
                          MetresText(nav.dead_reckoning_final_error_m)),
              {.size = 16.0, .is_bold = true});
  canvas.Text(
      {chart::kLeft, 44.0},
      fmt::format("{} \u00b7 estimate as known at the time, against the truth", RunName(source)),
      {.size = 12.5, .fill = palette::kMuted});
  const double x_high = std::max(Largest(curve.time_s) / 60.0, 0.1);
  PlotAxes axes(
      canvas,
      {.corner = {chart::kLeft, 92.0},
       .size = {chart::kWidth, 170.0},
       .x = {0.0, x_high},
       .y = {0.0, 1.08 * std::max({Largest(curve.error_m), Largest(curve.dead_reckoning_m), 0.1})},
       .x_label = "",
       .y_label = "3-D error [m]",
       .has_x_labels = false,
       .y_ticks = 5});
  axes.Curve(Minutes(curve.dead_reckoning_time_s), curve.dead_reckoning_m, kDeadReckoning);
  axes.Curve(Minutes(curve.time_s), curve.error_m, kEstimate);
  DrawKey(canvas, {chart::kLeft, 71.0}, "estimate", kEstimate);
  DrawKey(canvas, {chart::kLeft + 120.0, 71.0}, "dead reckoning", kDeadReckoning);
  canvas.Rect({chart::kLeft + 280.0, 65.0}, {26.0, 12.0}, chart::kBounds);
  canvas.Text({chart::kLeft + 313.0, 75.0}, "\u00b13 standard deviations, as the estimator says");
  const std::vector<double> minutes = Minutes(curve.time_s);
  for (const ErrorPanel& panel :
       {ErrorPanel{284.0, "north [m]", curve.north_m, curve.sd_north_m},
        ErrorPanel{388.0, "east [m]", curve.east_m, curve.sd_east_m},
        ErrorPanel{492.0, "down [m]", curve.down_m, curve.sd_down_m, true}}) {
    DrawAxis(canvas, panel, minutes, x_high);
  }
  return {
      source.record.name + "_navigation.svg",
      fmt::format("Above: distance between estimate and truth. Below: the same by axis, with the "
                  "bounds that the estimator itself gives; an honest estimator stays inside. Its "
                  "NEES is {} (3 is ideal, more is overconfident).",
                  NumberText(nav.nees_mean)),
      canvas.Finish()};
}

}  // namespace limpet
