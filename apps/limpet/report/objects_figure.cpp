// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>

#include "apps/limpet/report/figures.hpp"
#include "apps/limpet/report/map_axes.hpp"
#include "apps/limpet/report/map_symbols.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr Paint kSigma{.stroke = palette::kBlue, .width = 1.6};
constexpr Paint kMapSpread{.fill = palette::kOrange, .opacity = 0.35};

void DrawBelief(MapAxes& map, const OpiBelief& opi) {
  const Eigen::Vector3d ned(opi.ned[0], opi.ned[1], opi.ned[2]);
  const Eigen::Vector3d centroid(opi.centroid[0], opi.centroid[1], opi.centroid[2]);
  const auto& sd = opi.centroid_sd;
  DrawCovariance(map, centroid, {sd[0] * sd[0], 0.0, sd[1] * sd[1]}, 2.0, kMapSpread);
  map.canvas().Circle(map.At(centroid.x(), centroid.y()), 2.6, {.fill = palette::kOrange});
  DrawCovariance(map, ned, {opi.cov[0], opi.cov[1], opi.cov[3]}, 2.0, kSigma);
  DrawCross(map.canvas(), map.At(ned.x(), ned.y()), 4.0, {.stroke = palette::kBlue, .width = 2.0});
}

/// Name and probability beside each object; an object without a true one says so.
void LabelBeliefs(MapAxes& map, const FigureSource& source) {
  for (const OpiScore& opi : source.score.opis.found) {
    const Point at = map.At(opi.slam_ned.x(), opi.slam_ned.y()) + Point(20.0, -12.0);
    map.canvas().Text(at, opi.truth,
                      {.size = 13.0, .fill = palette::kMapInk, .is_bold = true, .has_halo = true});
    map.canvas().Text(at + Point(0.0, 15.0),
                      fmt::format("P {:.3f}, {:.2f} m off", opi.probability, opi.error_m),
                      {.fill = palette::kMapInk, .has_halo = true});
  }
  for (const FalseOpi& opi : source.score.opis.invented) {
    map.canvas().Text(map.At(opi.ned.x(), opi.ned.y()) + Point(20.0, -4.0),
                      fmt::format("nothing is here, P {:.3f}", opi.probability),
                      {.fill = palette::kVermillion, .is_bold = true, .has_halo = true});
  }
}

void DrawObjectsLegend(MapAxes& map) {
  map.LegendHeading("Truth");
  map.Legend(
      [](SvgCanvas& canvas, const Point& at) {
        canvas.Circle(at, 8.0, {.stroke = palette::kMapInk, .width = 1.4});
      },
      "object, at its true size");
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

}  // namespace

Figure ObjectsFigure(const FigureSource& source) {
  const SessionRecord& record = source.record;
  const OpiScores& opis = source.score.opis;
  const SurveyArea area = AreaOf(record);
  MapAxes map(area,
              fmt::format("Objects found: {} of {}, {} invented", opis.found.size(),
                          opis.found.size() + opis.missed.size(), opis.invented.size()),
              RunName(source) + " \u00b7 on the ground seen (darker: seen higher up)");
  map.BeginMap();
  map.Raster(
      record.grid,
      [&](std::size_t cell) {
        const double top = std::max(area.object_height_max, 0.1);
        const double share =
            std::clamp(static_cast<double>(record.grid.seen_height[cell]) / top, 0.0, 1.0);
        return palette::Coverage(std::round(share * 8.0) / 8.0);
      },
      0.45);
  map.Outline(area);
  for (const ScenarioOpi& opi : source.scenario.opis) {
    if (const auto place = opi.Place(record.name)) DrawTruth(map, *place, opi.radius_m);
  }
  for (const OpiBelief& opi : record.opis) {
    if (opi.probability >= 0.5) DrawBelief(map, opi);
  }
  LabelBeliefs(map, source);
  map.EndMap();
  DrawObjectsLegend(map);
  return {
      record.name + "_objects.svg",
      "Each object that the vehicle believes to be there (P at least 0.5), where smoother and map "
      "place it, over the ring of the true object. Ellipses hold 2 standard deviations "
      "(86 % of the chance in the plane).",
      map.Finish()};
}

}  // namespace limpet
