// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "limpet/core/interval.hpp"
#include "limpet/figures/palette.hpp"
#include "limpet/figures/plot_axes.hpp"
#include "limpet/figures/svg_canvas.hpp"
#include "limpet/figures/tick_marks.hpp"
#include "limpet/tuning/tuning_report.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr double kFigureLeft = 76.0, kFigureWidth = 814.0, kFigureTop = 96.0;
constexpr double kPanelHeight = 230.0, kPanelGap = 64.0;
constexpr double kCoordinatesHeight = 260.0;
constexpr std::size_t kPanelsInRow = 3;

struct Shown {
  const Contender* contender;
  MeanInterval objective;
  bool is_winner = false;
};

std::vector<Shown> ShownOf(const TuningTask& task, const TuningOutcome& outcome) {
  std::vector<Shown> shown;
  for (std::size_t i = 0; i < outcome.contenders.size(); ++i) {
    const auto objective = ObjectiveOf(task, outcome.contenders[i]);
    if (!objective) continue;
    shown.push_back({&outcome.contenders[i], *objective, outcome.winner == i});
  }
  // What must be seen is drawn last.
  std::ranges::stable_sort(shown, {}, [](const Shown& each) {
    return each.is_winner ? 3 : each.contender->is_default ? 2 : each.contender->is_in() ? 1 : 0;
  });
  return shown;
}

std::string_view ColorOf(const Shown& shown) {
  if (shown.is_winner) return palette::kGreen;
  if (shown.contender->is_default) return palette::kVermillion;
  return shown.contender->is_in() ? palette::kBlue : palette::kMuted;
}

Interval Widened(double low, double high) {
  const double margin = high > low ? 0.06 * (high - low) : std::max(1.0, 0.05 * std::abs(low));
  return {low - margin, high + margin};
}

/// The range that shows all means, and the intervals as far as they do not squeeze the rest.
Interval ObjectiveRange(const std::vector<Shown>& shown) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Shown& each : shown) {
    low = std::min(low, each.objective.mean);
    high = std::max(high, each.objective.mean);
  }
  const double spread = std::max(high - low, 1e-9 + 0.02 * std::abs(high));
  double wide_low = low, wide_high = high;
  for (const Shown& each : shown) {
    wide_low = std::min(wide_low, each.objective.low.value_or(low));
    wide_high = std::max(wide_high, each.objective.high.value_or(high));
  }
  return Widened(std::max(wide_low, low - 1.5 * spread), std::min(wide_high, high + 1.5 * spread));
}

/// The values of one parameter that were flown, the default's also where it lies outside.
Interval ValueRange(const VariedParameter& parameter, std::size_t index,
                    const std::vector<Shown>& shown) {
  double low = parameter.low, high = parameter.high;
  for (const Shown& each : shown) {
    low = std::min(low, each.contender->setting[index]);
    high = std::max(high, each.contender->setting[index]);
  }
  return Widened(low, high);
}

struct Panel {
  std::size_t parameter = 0;
  Point corner, size;
  bool is_first_in_row = false;
};

/// The objective over one parameter: a dot and an interval for each setting.
void DrawResponse(SvgCanvas& canvas, const ParameterSpace& space, const std::vector<Shown>& shown,
                  const Panel& panel) {
  const VariedParameter& parameter = space.parameters()[panel.parameter];
  const Interval y = ObjectiveRange(shown);
  const PlotAxes axes(canvas, {.corner = panel.corner,
                               .size = panel.size,
                               .x = ValueRange(parameter, panel.parameter, shown),
                               .y = y,
                               .x_label = parameter.name,
                               .y_label = panel.is_first_in_row ? "objective" : ""});
  canvas.BeginClip(panel.corner, panel.size);
  for (const Shown& each : shown) {
    const double x = each.contender->setting[panel.parameter];
    const bool is_marked = each.is_winner || each.contender->is_default;
    const double opacity = is_marked ? 1.0 : each.contender->is_in() ? 0.75 : 0.4;
    if (each.objective.low) {
      canvas.Line(axes.At({x, *each.objective.low}), axes.At({x, *each.objective.high}),
                  {.stroke = ColorOf(each), .width = is_marked ? 2.2 : 1.2, .opacity = opacity});
    }
    canvas.Circle(
        axes.At({x, each.objective.mean}), is_marked ? 5.0 : 3.2,
        {.fill = ColorOf(each), .stroke = palette::kPaper, .width = 1.0, .opacity = opacity});
  }
  canvas.EndClip();
}

/// A vertical axis of the parallel coordinates.
struct Coordinate {
  std::string name;
  double x_px = 0.0;
  Interval range;
  [[nodiscard]] double Share(double value) const {
    return (value - range.low) / (range.high - range.low);
  }
};

void DrawCoordinate(SvgCanvas& canvas, const Coordinate& coordinate, double top) {
  const double x = coordinate.x_px, bottom = top + kCoordinatesHeight;
  canvas.Line({x, top}, {x, bottom}, {.stroke = palette::kMuted, .width = 1.2});
  canvas.Text({x, top - 12.0}, coordinate.name, {.anchor = Anchor::kMiddle, .is_bold = true});
  for (const double tick : TickMarks(coordinate.range, 5)) {
    const double y = bottom - coordinate.Share(tick) * kCoordinatesHeight;
    canvas.Line({x - 4.0, y}, {x + 4.0, y}, {.stroke = palette::kMuted, .width = 1.0});
    canvas.Text({x - 8.0, y + 4.0}, TickText(tick),
                {.size = 11.0, .anchor = Anchor::kEnd, .fill = palette::kMuted, .has_halo = true});
  }
}

/// Each setting as a line through its values to its objective.
void DrawCoordinates(SvgCanvas& canvas, const ParameterSpace& space,
                     const std::vector<Shown>& shown, double top) {
  std::vector<Coordinate> coordinates;
  const std::size_t count = space.parameters().size();
  const double step = kFigureWidth / static_cast<double>(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    coordinates.push_back({.name = space.parameters()[i].name,
                           .x_px = kFigureLeft + (static_cast<double>(i) + 0.5) * step,
                           .range = ValueRange(space.parameters()[i], i, shown)});
  }
  double low = shown.front().objective.mean, high = low;
  for (const Shown& each : shown) {
    low = std::min(low, each.objective.mean);
    high = std::max(high, each.objective.mean);
  }
  coordinates.push_back({.name = "objective",
                         .x_px = kFigureLeft + (static_cast<double>(count) + 0.5) * step,
                         .range = Widened(low, high)});
  for (const Shown& each : shown) {
    std::vector<Point> way;
    for (std::size_t i = 0; i <= count; ++i) {
      const double value = i < count ? each.contender->setting[i] : each.objective.mean;
      way.emplace_back(coordinates[i].x_px,
                       top + kCoordinatesHeight * (1.0 - coordinates[i].Share(value)));
    }
    const bool is_marked = each.is_winner || each.contender->is_default;
    canvas.Polyline(way, {.stroke = ColorOf(each),
                          .width = is_marked ? 2.6 : 1.2,
                          .opacity = is_marked                 ? 1.0
                                     : each.contender->is_in() ? 0.6
                                                               : 0.3});
  }
  for (const Coordinate& coordinate : coordinates)
    DrawCoordinate(canvas, coordinate, top);
}

void DrawTuningKeys(SvgCanvas& canvas) {
  double x = kFigureLeft;
  for (const auto& [text, color] : {std::pair{"default", palette::kVermillion},
                                    std::pair{"best beside the default", palette::kGreen},
                                    std::pair{"flown with every seed", palette::kBlue},
                                    std::pair{"eliminated", palette::kMuted}}) {
    canvas.Circle({x + 6.0, 69.0}, 4.5, {.fill = color});
    canvas.Text({x + 17.0, 73.0}, text);
    x += 40.0 + 6.6 * static_cast<double>(std::string_view(text).size());
  }
}

}  // namespace

std::string TuneFigure(const TuningTask& task, const ParameterSpace& space,
                       const TuningOutcome& outcome) {
  const std::vector<Shown> shown = ShownOf(task, outcome);
  const std::size_t count = space.parameters().size();
  const std::size_t rows = (count + kPanelsInRow - 1) / kPanelsInRow;
  const bool has_coordinates = count > 1 && !shown.empty();
  const double coordinates_top =
      kFigureTop + static_cast<double>(rows) * (kPanelHeight + kPanelGap) + 26.0;
  SvgCanvas canvas(
      {kFigureLeft + kFigureWidth + 24.0,
       has_coordinates ? coordinates_top + kCoordinatesHeight + 30.0 : coordinates_top - 26.0},
      "Tuning");
  canvas.Text({kFigureLeft, 24.0},
              fmt::format("{} {}", task.maximises ? "Greatest" : "Least", task.objective),
              {.size = 16.0, .is_bold = true});
  canvas.Text(
      {kFigureLeft, 44.0},
      fmt::format("{} \u00b7 {}, {} settings, up to {} seeds each; means with 95 % "
                  "intervals (Student)",
                  task.mission, task.rules.method, outcome.contenders.size(), task.rules.runs),
      {.size = 12.5, .fill = palette::kMuted});
  DrawTuningKeys(canvas);
  const std::size_t columns = std::min(count, kPanelsInRow);
  const double width =
      (kFigureWidth - static_cast<double>(columns - 1) * kPanelGap) / static_cast<double>(columns);
  for (std::size_t i = 0; i < count && !shown.empty(); ++i) {
    const auto column = static_cast<double>(i % kPanelsInRow);
    const auto row = static_cast<double>(i / kPanelsInRow);
    DrawResponse(canvas, space, shown,
                 {.parameter = i,
                  .corner = {kFigureLeft + column * (width + kPanelGap),
                             kFigureTop + row * (kPanelHeight + kPanelGap)},
                  .size = {width, kPanelHeight},
                  .is_first_in_row = i % kPanelsInRow == 0});
  }
  if (has_coordinates) DrawCoordinates(canvas, space, shown, coordinates_top);
  return canvas.Finish();
}

}  // namespace limpet
