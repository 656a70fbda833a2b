// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/site_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
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
  /// Whether it has a letter for a place. A zone may reach beyond all that is drawn.
  [[nodiscard]] bool Holds(const PlanePoint& at) const {
    const double row = (corner.x() - at.x()) / step.x(), column = (at.y() - corner.y()) / step.y();
    return row >= -0.5 && column >= -0.5 && row < static_cast<double>(lines.size()) - 0.5 &&
           column < static_cast<double>(lines.front().size()) - 0.5;
  }
  char& At(const PlanePoint& at) { return lines[RowOf(at)][ColumnOf(at)]; }
};

/// Whether it or a letter beside it is `letter`.
bool HasNear(const std::vector<std::string>& lines, char letter, std::size_t row,
             std::size_t column) {
  for (std::size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < lines.size(); ++r) {
    const std::size_t first = column > 0 ? column - 1 : 0;
    if (lines[r].substr(first, column + 2 - first).find(letter) != std::string::npos) return true;
  }
  return false;
}

/// Of a polygon narrower than a letter no letter's middle need be inside: its border is drawn with
/// the polygon's letter, over those of `over`.
void DrawNarrows(const SimplePolygon& polygon, char drawn, std::string_view over, LetterMap& map) {
  const std::vector<std::string> sampled = map.lines;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlaneEdge edge = polygon.Edge(i);
    const PlanePoint along = edge.to - edge.from;
    const auto pieces = std::max(1L, std::lround(2.0 * along.norm() / map.step.minCoeff()));
    for (long piece = 0; piece <= pieces; ++piece) {
      const PlanePoint at =
          edge.from + static_cast<double>(piece) / static_cast<double>(pieces) * along;
      if (!map.Holds(at) || HasNear(sampled, drawn, map.RowOf(at), map.ColumnOf(at))) continue;
      char& letter = map.At(at);
      if (over.find(letter) != std::string_view::npos) letter = drawn;
    }
  }
}

/// What the letters that occur in `drawing` stand for.
std::string LegendText(const std::string& drawing) {
  constexpr std::array<std::pair<char, const char*>, 5> kMeanings{
      {{':', "ground to be seen"},
       {'.', "the rest of the operating region"},
       {'#', "keep-out zone"},
       {'o', "way point of the transit"},
       {'S', "start and home"}}};
  std::string legend;
  for (const auto& [letter, meaning] : kMeanings) {
    if (drawing.find(letter) == std::string::npos) continue;
    legend += fmt::format("{}{} {}", legend.empty() ? "" : ", ", letter, meaning);
  }
  return legend + "\n";
}

std::string FiguresText(const Site& site) {
  const std::string time =
      site.speed_mps > 0.0
          ? fmt::format(", {:.0f} s at {:g} m/s", site.path_m / site.speed_mps, site.speed_mps)
          : "";
  return fmt::format("{:.0f} m2 to be seen; lanes and turns of about {:.0f} m{}\n", site.wanted_m2,
                     site.path_m, time);
}

/// What lies `margin` beyond the area, where the vehicle may be if no region is said: its border in
/// pieces, since where two sides face each other it has none.
std::vector<std::vector<PlanePoint>> BorderBeyond(const SimplePolygon& outline, double margin) {
  constexpr double kTurn = 0.1;    // between two points around a corner [rad]
  constexpr double kTouch = 1e-6;  // [m]
  constexpr double kFinest = 1.0 / 64;
  std::vector<std::vector<PlanePoint>> pieces(1);
  const auto take = [&](const PlanePoint& at) {
    if (-outline.Depth(at) >= margin - kTouch) {
      pieces.back().push_back(at);
    } else if (!pieces.back().empty()) {
      pieces.emplace_back();
    }
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlaneEdge edge = outline.Edge(i);
    const PlanePoint along = edge.to - edge.from;
    PlanePoint off = PlanePoint(-along.y(), along.x()).normalized() * margin;
    const PlanePoint middle = edge.from + 0.5 * along;
    const bool is_inward = outline.Contains(middle + 1e-3 * off.normalized());
    if (is_inward) off = -off;
    for (double share = 0.0; share <= 1.0; share += kFinest)
      take(edge.from + share * along + off);
    // Around the corner; where the next side begins sooner, those places are not of the border.
    const double turn = is_inward ? kTurn : -kTurn;
    for (double angle = turn; std::abs(angle) < std::numbers::pi; angle += turn) {
      const PlanePoint around(off.x() * std::cos(angle) - off.y() * std::sin(angle),
                              off.x() * std::sin(angle) + off.y() * std::cos(angle));
      const PlanePoint at = edge.to + around;
      if (-outline.Depth(at) < margin - kTouch) break;
      take(at);
    }
  }
  return pieces;
}

/// What MapAxes leaves out: the region, if the mission does not say it.
void DrawRegion(const Site& site, MapAxes& map) {
  const SurveyShape shape = *SurveyShape::Of(site.area);
  if (shape.region() || shape.margin() <= 0.0) return;
  const Paint thin{.stroke = palette::kMapMuted, .width = 0.7};
  const auto draw = [&](const std::vector<PlanePoint>& border) {
    std::vector<SvgCanvas::Point> line;
    for (const PlanePoint& at : border)
      line.push_back(map.At(at.x(), at.y()));
    if (line.size() > 1) map.canvas().Polyline(line, thin);
  };
  if (shape.is_plain()) {
    const Region region(site.area);
    const double south = region.north_min(), north = region.north_max();
    const double west = region.east_min(), east = region.east_max();
    draw({{south, west}, {north, west}, {north, east}, {south, east}, {south, west}});
    return;
  }
  for (const std::vector<PlanePoint>& piece : BorderBeyond(shape.outline(), shape.margin()))
    draw(piece);
}

/// A line of the legend that is a piece of line.
void LineLegend(MapAxes& map, const Paint& paint, const std::string& text) {
  map.Legend(
      [paint](SvgCanvas& canvas, const SvgCanvas::Point& at) {
        canvas.Line(at - SvgCanvas::Point(10.0, 0.0), at + SvgCanvas::Point(10.0, 0.0), paint);
      },
      text);
}

/// Of what is drawn, and of nothing else.
void DrawLegend(const Site& site, MapAxes& map) {
  const SurveyShape shape = *SurveyShape::Of(site.area);
  LineLegend(map, {.stroke = palette::kMapMuted, .width = 1.0, .dash = "5 4"}, "area to survey");
  if (shape.region() || shape.margin() > 0.0) {
    LineLegend(map, {.stroke = palette::kMapMuted, .width = 0.7}, "operating region");
  }
  if (!shape.zones().empty()) {
    map.Legend(
        [](SvgCanvas& canvas, const SvgCanvas::Point& at) {
          canvas.Rect(at - SvgCanvas::Point(8.0, 5.0), {16.0, 10.0},
                      {.fill = palette::kMapMuted, .opacity = 0.5});
        },
        "keep-out zone");
  }
  if (!shape.transit().empty()) {
    LineLegend(map, {.stroke = palette::kBlue, .width = 1.5}, "transit");
  }
  if (site.start) {
    map.Legend(
        [](SvgCanvas& canvas, const SvgCanvas::Point& at) {
          canvas.Circle(at, 5.0, {.fill = palette::kVermillion});
        },
        "start and home");
  }
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
  DrawNarrows(shape.outline(), ':', " .", map);
  for (const SimplePolygon& zone : shape.zones())
    DrawNarrows(zone, '#', " .:", map);
  for (const PlanePoint& at : region.transit())
    map.At(at) = 'o';
  if (site.start) map.At(*site.start) = 'S';
  std::string text;
  for (std::string& line : map.lines) {
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text + LegendText(text) + FiguresText(site);
}

std::string SiteSvg(const Site& site) {
  const Region region(site.area);
  const DrawnBox box = BoxOf(site, region);
  // Room for the marks at the edges, whatever the scale.
  const double room = std::max(1.0, 0.02 * (box.high - box.low).maxCoeff());
  const SurveyArea frame{.north_min = box.low.x(),
                         .north_max = box.high.x(),
                         .east_min = box.low.y(),
                         .east_max = box.high.y(),
                         .margin = room};
  std::string figures = FiguresText(site);
  figures.pop_back();
  MapAxes map(frame, "What " + site.name + " surveys", figures);
  map.BeginMap();
  map.Outline(site.area);
  DrawRegion(site, map);
  std::vector<SvgCanvas::Point> way;
  if (site.start) way.push_back(map.At(site.start->x(), site.start->y()));
  for (const PlanePoint& at : region.transit())
    way.push_back(map.At(at.x(), at.y()));
  if (way.size() > 1) map.canvas().Polyline(way, {.stroke = palette::kBlue, .width = 1.5});
  if (site.start) {
    map.canvas().Circle(way.front(), 5.0, {.fill = palette::kVermillion});
  }
  map.EndMap();
  DrawLegend(site, map);
  return map.Finish();
}

}  // namespace limpet
