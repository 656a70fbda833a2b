// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/site_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "limpet/figures/map_axes.hpp"
#include "limpet/preflight/survey_facts.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// The box of everything that is drawn.
struct DrawnBox {
  PlanePoint low, high;
  void Take(const PlanePoint& at) {
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
};

DrawnBox BoxOf(const Site& site, const Region& region) {
  DrawnBox box{{region.north_min(), region.east_min()}, {region.north_max(), region.east_max()}};
  box.Take({site.area.north_min, site.area.east_min});
  box.Take({site.area.north_max, site.area.east_max});
  for (const PlanePoint& at : region.transit())
    box.Take(at);
  if (site.start) box.Take(*site.start);
  return box;
}

char LetterAt(const SurveyShape& shape, const Region& region, const PlanePoint& at) {
  const bool is_in_zone = std::ranges::any_of(
      shape.zones(), [&at](const SimplePolygon& zone) { return zone.Contains(at); });
  if (is_in_zone) return '#';
  if (shape.outline().Contains(at)) return ':';
  return region.Contains(at.x(), at.y()) ? '.' : ' ';
}

/// The area drawn by letters, north up.
struct LetterMap {
  PlanePoint corner;  ///< of the first letter, north-west
  PlanePoint step;    ///< from row to row, from column to column [m]
  std::vector<std::string> lines;

  [[nodiscard]] PlanePoint Place(std::size_t row, std::size_t column) const {
    return {corner.x() - static_cast<double>(row) * step.x(),
            corner.y() + static_cast<double>(column) * step.y()};
  }
  [[nodiscard]] std::size_t RowOf(const PlanePoint& at) const {
    return static_cast<std::size_t>(std::lround((corner.x() - at.x()) / step.x()));
  }
  [[nodiscard]] std::size_t ColumnOf(const PlanePoint& at) const {
    return static_cast<std::size_t>(std::lround((at.y() - corner.y()) / step.y()));
  }
  char& At(const PlanePoint& at) { return lines[RowOf(at)][ColumnOf(at)]; }
};

/// Whether it or a letter beside it is ground of the area.
bool HasGroundNear(const std::vector<std::string>& lines, std::size_t row, std::size_t column) {
  for (std::size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < lines.size(); ++r) {
    const std::size_t first = column > 0 ? column - 1 : 0;
    if (lines[r].substr(first, column + 2 - first).find(':') != std::string::npos) return true;
  }
  return false;
}

/// Of an area narrower than a letter no letter's middle need be ground: its border is drawn.
void DrawNarrows(const SimplePolygon& outline, LetterMap& map) {
  const std::vector<std::string> sampled = map.lines;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlaneEdge edge = outline.Edge(i);
    const PlanePoint along = edge.to - edge.from;
    const auto pieces = std::max(1L, std::lround(2.0 * along.norm() / map.step.minCoeff()));
    for (long piece = 0; piece <= pieces; ++piece) {
      const PlanePoint at =
          edge.from + static_cast<double>(piece) / static_cast<double>(pieces) * along;
      char& letter = map.At(at);
      const bool is_empty = letter == ' ' || letter == '.';
      if (is_empty && !HasGroundNear(sampled, map.RowOf(at), map.ColumnOf(at))) letter = ':';
    }
  }
}

std::string FiguresText(const Site& site) {
  const std::string time =
      site.speed_mps > 0.0
          ? fmt::format(", {:.0f} s at {:g} m/s", site.path_m / site.speed_mps, site.speed_mps)
          : "";
  return fmt::format("{:.0f} m2 to be seen; lanes and turns of about {:.0f} m{}\n", site.wanted_m2,
                     site.path_m, time);
}

}  // namespace

std::optional<Site> SiteOf(const fs::path& path, const MissionChange& change) {
  const fs::path file = MissionFileAt(path);
  if (file.extension() != ".moos" || !fs::exists(file)) return std::nullopt;
  try {
    MissionFile mission = LoadMission(file);
    if (change) change(mission);
    const MissionReading reading(mission, file.parent_path());
    const std::optional<SurveyFacts> facts = ReadSurveyFacts(reading);
    if (!facts || facts->problem || facts->wanted_m2 <= 0.0) return std::nullopt;
    Site site{.name = fs::weakly_canonical(file).parent_path().filename().string(),
              .area = facts->area,
              .start = {},
              .wanted_m2 = facts->wanted_m2,
              .path_m = EstimatePath(*facts, reading.Find("pSurvey", "coverage_kind")->text,
                                     reading.Find("pSurvey", "coverage_target")->number())
                            .total(),
              .speed_mps = facts->speed.number()};
    if (reading.scenario()) {
      site.start.emplace(reading.scenario()->start.north_m, reading.scenario()->start.east_m);
    }
    return site;
  } catch (const ConfigError&) {
    return std::nullopt;  // the check says what is wrong
  }
}

std::string SiteText(const Site& site, int columns) {
  const SurveyShape shape = *SurveyShape::Of(site.area);
  const Region region(site.area);
  const DrawnBox box = BoxOf(site, region);
  // A letter is about twice as high as wide.
  constexpr double kLetterShape = 2.0;
  constexpr int kMostRows = 50;
  const PlanePoint extent = box.high - box.low;
  const double east_step = std::max(extent.y() / columns, extent.x() / (kLetterShape * kMostRows));
  const double north_step = kLetterShape * east_step;
  const int rows = static_cast<int>(std::ceil(extent.x() / north_step)) + 1;
  const int width = static_cast<int>(std::ceil(extent.y() / east_step)) + 1;
  LetterMap map{
      .corner = {box.high.x(), box.low.y()},
      .step = {north_step, east_step},
      .lines = {static_cast<std::size_t>(rows), std::string(static_cast<std::size_t>(width), ' ')}};
  for (std::size_t row = 0; row < map.lines.size(); ++row) {
    for (std::size_t column = 0; column < map.lines[row].size(); ++column) {
      map.lines[row][column] = LetterAt(shape, region, map.Place(row, column));
    }
  }
  DrawNarrows(shape.outline(), map);
  for (const PlanePoint& at : region.transit())
    map.At(at) = 'o';
  if (site.start) map.At(*site.start) = 'S';
  std::string text;
  for (std::string& line : map.lines) {
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text + FiguresText(site);
}

std::string SiteSvg(const Site& site) {
  const Region region(site.area);
  const DrawnBox box = BoxOf(site, region);
  const SurveyArea frame{.north_min = box.low.x(),
                         .north_max = box.high.x(),
                         .east_min = box.low.y(),
                         .east_max = box.high.y(),
                         .margin = 1.0};
  std::string figures = FiguresText(site);
  figures.pop_back();
  MapAxes map(frame, "What " + site.name + " surveys", figures);
  map.BeginMap();
  map.Outline(site.area);
  std::vector<SvgCanvas::Point> way;
  if (site.start) way.push_back(map.At(site.start->x(), site.start->y()));
  for (const PlanePoint& at : region.transit())
    way.push_back(map.At(at.x(), at.y()));
  if (way.size() > 1) map.canvas().Polyline(way, {.stroke = palette::kBlue, .width = 1.5});
  if (site.start) {
    map.canvas().Circle(way.front(), 5.0, {.fill = palette::kVermillion});
  }
  map.EndMap();
  map.Legend(
      [](SvgCanvas& canvas, const SvgCanvas::Point& at) {
        canvas.Line(at - SvgCanvas::Point(10.0, 0.0), at + SvgCanvas::Point(10.0, 0.0),
                    {.stroke = palette::kMapMuted, .width = 1.0, .dash = "5 4"});
      },
      "area to survey");
  map.Legend(
      [](SvgCanvas& canvas, const SvgCanvas::Point& at) {
        canvas.Rect(at - SvgCanvas::Point(8.0, 5.0), {16.0, 10.0},
                    {.fill = palette::kMapMuted, .opacity = 0.5});
      },
      "keep-out zone");
  map.Legend(
      [](SvgCanvas& canvas, const SvgCanvas::Point& at) {
        canvas.Circle(at, 5.0, {.fill = palette::kVermillion});
      },
      "start and home");
  return map.Finish();
}

}  // namespace limpet
