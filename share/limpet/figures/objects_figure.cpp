// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "limpet/figures/figures.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/map_symbols.hpp"
#include "limpet/figures/probability_text.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr Paint kSigma{.stroke = palette::kBlue, .width = 1.6};
constexpr double kCloseUp = 190.0;  ///< side of a close-up [px]
constexpr Paint kMapSpread{.fill = palette::kOrange, .opacity = 0.35};

/// An object as the vehicle knows it, `scale` pixels per metre, around where `at` draws NED.
struct Drawing {
  SvgCanvas& canvas;
  double scale;
  std::function<Point(const Eigen::Vector2d& p_W)> at;
};

void DrawBelief(const Drawing& drawing, const OpiBelief& opi) {
  const auto& sd = opi.centroid_sd_W;
  const Eigen::Matrix3d& S = opi.object.cov_W;
  const Point centroid = drawing.at(opi.centroid_W.head<2>());
  const Point place = drawing.at(opi.object.p_W.head<2>());
  if (sd[0] + sd[1] > 0.0) {  // else the map has no voxels of it
    DrawCovariance(drawing.canvas, centroid, 2.0 * drawing.scale,
                   {sd[0] * sd[0], 0.0, sd[1] * sd[1]}, kMapSpread);
    drawing.canvas.Circle(centroid, 2.6, {.fill = palette::kOrange});
  }
  DrawCovariance(drawing.canvas, place, 2.0 * drawing.scale, {S(0, 0), S(0, 1), S(1, 1)}, kSigma);
  DrawCross(drawing.canvas, place, 4.0, {.stroke = palette::kBlue, .width = 2.0});
}

std::string Chance(const OpiBelief& opi) { return "P " + ProbabilityText(opi.posterior.present()); }

/// Name and probability beside each object; an object without a true one says so.
void LabelBeliefs(MapAxes& map, const FigureSource& source) {
  for (const OpiScore& opi : source.score.opis.found) {
    DrawLabel(map, opi.belief.object.p_W,
              {.lines = {opi.truth, Chance(opi.belief)}, .distance = 20.0});
  }
  for (const OpiBelief& opi : source.score.opis.reported) {
    DrawLabel(map, opi.object.p_W,
              {.lines = {fmt::format("id {}", opi.id), Chance(opi)}, .distance = 20.0});
  }
  for (const OpiBelief& opi : source.score.opis.invented) {
    DrawLabel(map, opi.object.p_W,
              {.lines = {"nothing is here", Chance(opi)},
               .distance = 20.0,
               .fill = palette::kVermillion});
  }
}

std::string HeightError(const OpiScore& opi) {
  const double error = std::round(100.0 * (opi.belief.object.p_W.z() - opi.truth_W.z())) / 100.0;
  if (error == 0.0) return "depth right to the centimetre";
  return fmt::format("{:.2f} m too {}", std::abs(error), error > 0.0 ? "deep" : "shallow");
}

/// 4 x 4 m around one true object.
void DrawCloseUp(SvgCanvas& canvas, const Point& corner, const FigureSource& source,
                 const OpiScore& opi) {
  constexpr double kMetres = 4.0;
  const double scale = kCloseUp / kMetres;
  const Point middle = corner + Point(0.5 * kCloseUp, 0.5 * kCloseUp);
  const Drawing drawing{canvas, scale, [&](const Eigen::Vector2d& p_W) {
                          return Point(middle.x() + (p_W.y() - opi.truth_W.y()) * scale,
                                       middle.y() - (p_W.x() - opi.truth_W.x()) * scale);
                        }};
  canvas.Rect(corner, {kCloseUp, kCloseUp}, {.fill = palette::kUnseen});
  canvas.BeginClip(corner, {kCloseUp, kCloseUp});
  canvas.Circle(middle, opi.radius_m * scale,
                {.fill = palette::kHalo, .stroke = palette::kMapInk, .width = 1.4});
  for (const OpiBelief& belief : source.record.opis) {
    if (belief.posterior.present() >= 0.5)
      DrawBelief(drawing, SmoothedBelief(belief, source.record.landmarks));
  }
  const Point bar = corner + Point(10.0, kCloseUp - 12.0);
  canvas.Line(bar, bar + Point(scale, 0.0), {.stroke = palette::kMapInk, .width = 2.0});
  canvas.Text(bar + Point(scale + 7.0, 4.0), "1 m", {.size = 11.0, .fill = palette::kMapInk});
  canvas.EndClip();
  canvas.Text(corner + Point(0.0, -8.0), opi.truth, {.size = 13.0, .is_bold = true});
  canvas.Text(corner + Point(0.0, kCloseUp + 17.0), fmt::format("{:.2f} m off", opi.error_m));
  canvas.Text(corner + Point(0.0, kCloseUp + 33.0), HeightError(opi), {.fill = palette::kMuted});
}

void DrawObjectsLegend(MapAxes& map, bool has_truth) {
  if (has_truth) {
    map.LegendHeading("Truth");
    map.Legend(
        [](SvgCanvas& canvas, const Point& at) {
          canvas.Circle(at, 8.0, {.stroke = palette::kMapInk, .width = 1.4});
        },
        "object, at its true size");
  }
  map.LegendHeading("Vehicle");
  map.Legend(
      [](SvgCanvas& canvas, const Point& at) {
        canvas.Ellipse(at, {11.0, 7.0}, 0.0, kSigma);
        DrawCross(canvas, at, 4.0, {.stroke = palette::kBlue, .width = 2.0});
      },
      "place by the smoother,\n2 standard deviations");
  map.Legend(
      [](SvgCanvas& canvas, const Point& at) {
        canvas.Ellipse(at, {11.0, 9.0}, 0.0, kMapSpread);
        canvas.Circle(at, 2.6, {.fill = palette::kOrange});
      },
      "cluster in the map:\ncentre and 2 standard\ndeviations of its voxels");
}

std::string TitleOfObjects(const SessionScore& score) {
  const OpiScores& opis = score.opis;
  if (!score.has_truth) {
    return fmt::format("Objects reported: {}, not judged: no truth", opis.reported.size());
  }
  return fmt::format("Objects found: {} of {}, {} invented", opis.found.size(),
                     opis.found.size() + opis.missed.size(), opis.invented.size());
}

}  // namespace

Figure ObjectsFigure(const FigureSource& source) {
  const SessionRecord& record = source.record;
  const SurveyArea area = AreaOf(record);
  MapAxes map(area, TitleOfObjects(source.score),
              RunName(source) + " \u00b7 on the ground seen (darker: seen higher up)");
  map.BeginMap();
  map.Raster(
      record.grid,
      [&](const SeenCell& cell) {
        const double top = std::max(area.object_height_max, 0.1);
        const double share = std::clamp(static_cast<double>(cell.seen_height) / top, 0.0, 1.0);
        return palette::Coverage(std::round(share * 8.0) / 8.0);
      },
      0.45);
  map.Outline(area);
  if (source.score.has_truth) {
    for (const ScenarioOpi& opi : source.scenario.opis) {
      if (const auto place = opi.Place(record.name)) DrawTruth(map, *place, opi.radius_m);
    }
  }
  const Drawing drawing{map.canvas(), map.pixels_per_metre(),
                        [&map](const Eigen::Vector2d& p_W) { return map.At(p_W); }};
  for (const OpiBelief& opi : record.opis) {
    if (opi.posterior.present() >= 0.5) DrawBelief(drawing, SmoothedBelief(opi, record.landmarks));
  }
  LabelBeliefs(map, source);
  map.EndMap();
  DrawObjectsLegend(map, source.score.has_truth);
  return {
      record.name + "_objects.svg",
      "Each object that the vehicle believes to be there (P at least 0.5), where smoother and map "
      "place it, over the ring of the true object where that is known. Ellipses hold 2 standard "
      "deviations "
      "(86 % of the chance in the plane).",
      map.Finish()};
}

Figure CloseUpFigure(const FigureSource& source) {
  constexpr double kLeft = 24.0, kTop = 92.0, kGap = 26.0, kPerRow = 4.0;
  const auto& found = source.score.opis.found;
  const double rows = std::ceil(static_cast<double>(found.size()) / kPerRow);
  SvgCanvas canvas(
      {2.0 * kLeft + kPerRow * (kCloseUp + kGap) - kGap, kTop + rows * (kCloseUp + 74.0) - 22.0},
      "Objects close up, " + source.record.name);
  canvas.Text({kLeft, 24.0}, "Objects close up: where they are and where they were said to be",
              {.size = 17.0, .is_bold = true});
  canvas.Text({kLeft, 44.0},
              RunName(source) + " \u00b7 4 \u00d7 4 m each, north up, around the true object",
              {.size = 12.5, .fill = palette::kMuted});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double column = static_cast<double>(i % 4), row = static_cast<double>(i / 4);
    DrawCloseUp(canvas, {kLeft + column * (kCloseUp + kGap), kTop + row * (kCloseUp + 74.0)},
                source, found[i]);
  }
  return {source.record.name + "_closeup.svg",
          "White disc: the object. Blue cross and ellipse: the smoother's place and two standard "
          "deviations. Orange: centre and two standard deviations of the map's voxels.",
          canvas.Finish()};
}

}  // namespace limpet
