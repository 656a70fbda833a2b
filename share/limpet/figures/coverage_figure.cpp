// SPDX-License-Identifier: MIT
#include <algorithm>

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
                 kCoverageHeight = 330.0;

std::vector<double> Percent(const std::vector<double>& shares) {
  std::vector<double> out;
  for (const double share : shares)
    out.push_back(100.0 * share);
  return out;
}

/// A dot where the curve reached each level, with the way it took.
void MarkLevels(SvgCanvas& canvas, const PlotAxes& axes, const std::vector<CoverageLevel>& levels,
                const Paint& paint, bool is_above) {
  for (const CoverageLevel& level : levels) {
    if (!level.path_m) continue;
    const Point at = axes.At(*level.path_m, 100.0 * level.level);
    canvas.Circle(at, 4.2, {.fill = paint.stroke, .stroke = palette::kPaper, .width = 1.5});
    canvas.Text(at + (is_above ? Point(-8.0, -4.0) : Point(8.0, 13.0)),
                fmt::format("{:.0f}", *level.path_m),
                {.size = 11.5,
                 .anchor = is_above ? Anchor::kEnd : Anchor::kStart,
                 .fill = paint.stroke,
                 .is_bold = true});
  }
}

/// The vehicle's own belief, over the same way.
void DrawBelieved(PlotAxes& axes, const FigureSource& source, double start_s) {
  std::vector<double> path, seabed, band;
  const double start_path = source.record.truth.PathAt(start_s);
  for (const Stamped<Coverage>& entry : source.record.believed_coverage) {
    if (entry.time.value() < start_s) continue;
    path.push_back(source.record.truth.PathAt(entry.time.value()) - start_path);
    seabed.push_back(100.0 * entry.value.seabed);
    band.push_back(100.0 * entry.value.band);
  }
  axes.Curve(path, seabed, {.stroke = palette::kBlue, .width = 1.2, .dash = "2 4"});
  axes.Curve(path, band, {.stroke = palette::kVermillion, .width = 1.2, .dash = "2 4"});
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
  key(kCoverageLeft + 520.0, {.stroke = palette::kMuted, .width = 1.2, .dash = "2 4"},
      "as the vehicle believed");
}

}  // namespace

Figure CoverageFigure(const FigureSource& source) {
  const CoverageScore& coverage = source.score.coverage;
  const auto footprint = source.settings.footprint_m();
  SvgCanvas canvas(kCoverageLeft + kCoverageWidth + 24.0, kCoverageTop + kCoverageHeight + 52.0,
                   "Coverage against way");
  canvas.Text({kCoverageLeft, 24.0},
              fmt::format("Seen at the end: {:.1f} % of the bottom, {:.1f} % of the band",
                          100.0 * coverage.covered, 100.0 * coverage.detected_band),
              {.size = 17.0, .is_bold = true});
  canvas.Text(
      {kCoverageLeft, 44.0},
      fmt::format("{} \u00b7 from the true poses, image {:.2f} \u00d7 {:.2f} m on the bottom",
                  RunName(source), footprint[0], footprint[1]),
      {.size = 12.5, .fill = palette::kMuted});
  const double far = std::max(coverage.curve.path_m.back(), 1.0);
  PlotAxes axes(canvas, {.corner = {kCoverageLeft, kCoverageTop},
                         .size = {kCoverageWidth, kCoverageHeight},
                         .x = {0.0, far},
                         .y = {0.0, 105.0},
                         .x_label = "way since the survey began [m]",
                         .y_label = "seen [%]"});
  for (const double level : {90.0, 95.0, 99.0}) {
    axes.Level(level, {.stroke = palette::kMuted, .width = 0.9, .dash = "6 4"});
  }
  DrawBelieved(axes, source, SurveyStartOf(source));
  axes.Curve(coverage.curve.path_m, Percent(coverage.curve.seabed), kSeabed);
  axes.Curve(coverage.curve.path_m, Percent(coverage.curve.band), kBand);
  MarkLevels(canvas, axes, coverage.seabed, kSeabed, true);
  MarkLevels(canvas, axes, coverage.band, kBand, false);
  DrawKeys(canvas, source);
  return {
      source.record.name + "_coverage.svg",
      "Dots and numbers: metres of way until 90, 95 and 99 % were reached. Bottom: one jittered "
      "point per 0.25 m cell. Band: object centres at random heights, seen well when 60 % of the "
      "object's disc was in the image in at least 3 frames.",
      canvas.Finish()};
}

}  // namespace limpet
