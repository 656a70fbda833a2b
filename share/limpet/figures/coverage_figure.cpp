// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "limpet/figures/figures.hpp"
#include "limpet/figures/palette.hpp"
#include "limpet/figures/plot_axes.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr Paint kSeabed{.stroke = palette::kBlue, .width = 2.2};
constexpr Paint kBand{.stroke = palette::kVermillion, .width = 2.2};
constexpr double kCoverageLeft = 76.0, kCoverageTop = 96.0, kCoverageWidth = 814.0,
                 kCoverageHeight = 300.0, kCoverageGap = 62.0;

/// What a panel is drawn against.
enum class Against { kWay, kTime };

std::vector<double> Percent(const std::vector<double>& shares) {
  std::vector<double> out;
  for (const double share : shares)
    out.push_back(100.0 * share);
  return out;
}

/// A dot where the curve reached each level, with the way or the time that it took.
void MarkLevels(SvgCanvas& canvas, const PlotAxes& axes, const std::vector<CoverageLevel>& levels,
                Against against, const Paint& paint, bool is_above) {
  for (const CoverageLevel& level : levels) {
    const std::optional<double>& x = against == Against::kWay ? level.path_m : level.time_s;
    if (!x) continue;
    const Point at = axes.At({*x, 100.0 * level.level});
    canvas.Circle(at, 4.2, {.fill = paint.stroke, .stroke = palette::kPaper, .width = 1.5});
    canvas.Text(at + (is_above ? Point(-8.0, -4.0) : Point(8.0, 13.0)), fmt::format("{:.0f}", *x),
                {.size = 11.5,
                 .anchor = is_above ? Anchor::kEnd : Anchor::kStart,
                 .fill = paint.stroke,
                 .is_bold = true});
  }
}

/// The vehicle's own belief, over the same way or time.
void DrawBelieved(PlotAxes& axes, const FigureSource& source, Against against) {
  const double start_s = SurveyStartOf(source);
  const PoseTrack& truth = source.record.truth;
  std::vector<double> x, seabed, band;
  for (const Stamped<Coverage>& entry : source.record.believed_coverage) {
    const double time = entry.time.value();
    if (time < start_s) continue;
    x.push_back(against == Against::kWay ? truth.PathAt(time) - truth.PathAt(start_s)
                                         : time - start_s);
    seabed.push_back(100.0 * entry.value.seabed);
    band.push_back(100.0 * entry.value.band);
  }
  axes.Curve(x, seabed, {.stroke = palette::kBlue, .width = 1.2, .dash = "2 4"});
  axes.Curve(x, band, {.stroke = palette::kVermillion, .width = 1.2, .dash = "2 4"});
}

void DrawPanel(SvgCanvas& canvas, const FigureSource& source, Against against, double top) {
  const CoverageScore& coverage = source.score.coverage;
  const bool is_way = against == Against::kWay;
  const std::vector<double>& x = is_way ? coverage.curve.path_m : coverage.curve.time_s;
  PlotAxes axes(canvas, {.corner = {kCoverageLeft, top},
                         .size = {kCoverageWidth, kCoverageHeight},
                         .x = {0.0, std::max(x.back(), 1.0)},
                         .y = {0.0, 105.0},
                         .x_label = is_way ? "way since the survey began [m]"
                                           : "time since the survey began [s]",
                         .y_label = "seen [%]"});
  for (const double level : {90.0, 95.0, 99.0}) {
    axes.Level(level, {.stroke = palette::kMuted, .width = 0.9, .dash = "6 4"});
  }
  const auto least = is_way && source.score.bound ? source.score.bound->path_m() : std::nullopt;
  if (least) {
    axes.Curve({*least, *least}, {0.0, 105.0}, {.stroke = palette::kMuted, .width = 1.2});
  }
  DrawBelieved(axes, source, against);
  axes.Curve(x, Percent(coverage.curve.seabed), kSeabed);
  axes.Curve(x, Percent(coverage.curve.band), kBand);
  MarkLevels(canvas, axes, coverage.seabed, against, kSeabed, true);
  MarkLevels(canvas, axes, coverage.band, against, kBand, false);
}

void DrawKeys(SvgCanvas& canvas, const FigureSource& source) {
  const auto key = [&](double x, const Paint& paint, const std::string& text) {
    canvas.Line({x, 73.0}, {x + 24.0, 73.0}, paint);
    canvas.Text({x + 31.0, 77.0}, text);
  };
  key(kCoverageLeft, kSeabed, "bottom inside the image");
  key(kCoverageLeft + 188.0, kBand,
      fmt::format("objects {:g} to {:g} m above it seen well", source.settings.object_radius_m,
                  source.settings.object_height_max_m));
  key(kCoverageLeft + 470.0, {.stroke = palette::kMuted, .width = 1.2, .dash = "2 4"},
      "as the vehicle believed");
  key(kCoverageLeft + 680.0, {.stroke = palette::kMuted, .width = 1.2}, "least way");
}

}  // namespace

Figure CoverageFigure(const FigureSource& source) {
  const CoverageScore& coverage = source.score.coverage;
  const auto footprint = source.settings.footprint_m();
  constexpr double kPanel = kCoverageHeight + kCoverageGap;
  SvgCanvas canvas({kCoverageLeft + kCoverageWidth + 24.0, kCoverageTop + 2.0 * kPanel - 10.0},
                   "Coverage against way and time");
  canvas.Text({kCoverageLeft, 24.0},
              fmt::format("Seen at the end: {:.1f} % of the bottom, {:.1f} % of the band",
                          100.0 * coverage.covered, 100.0 * coverage.detected_band),
              {.size = 17.0, .is_bold = true});
  canvas.Text(
      {kCoverageLeft, 44.0},
      fmt::format("{} \u00b7 from the true poses, image {:.2f} \u00d7 {:.2f} m on the bottom",
                  RunName(source), footprint[0], footprint[1]),
      {.size = 12.5, .fill = palette::kMuted});
  DrawPanel(canvas, source, Against::kWay, kCoverageTop);
  DrawPanel(canvas, source, Against::kTime, kCoverageTop + kPanel);
  DrawKeys(canvas, source);
  return {
      source.record.name + "_coverage.svg",
      "Dots and numbers: metres of way, and seconds, until 90, 95 and 99 % were reached. The thin "
      "upright line is the least way to see all of the band's top: area over swath. Bottom: one "
      "jittered "
      "point per 0.25 m cell. Band: object centres at random heights, seen well when 60 % of the "
      "object's disc was in the image in at least 3 frames.",
      canvas.Finish()};
}

}  // namespace limpet
