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

std::string FiguresText(const Site& site) {
  const std::string time =
      site.speed_mps > 0.0
          ? fmt::format(", {:.0f} s at {:g} m/s", site.path_m / site.speed_mps, site.speed_mps)
          : "";
  return fmt::format("{:.0f} m2 to be seen; lanes and turns of about {:.0f} m{}\n", site.wanted_m2,
                     site.path_m, time);
}

}  // namespace

std::optional<Site> SiteOf(const fs::path& path) {
  const fs::path file = MissionFileAt(path);
  if (file.extension() != ".moos" || !fs::exists(file)) return std::nullopt;
  try {
    const MissionFile mission = LoadMission(file);
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
  std::vector<std::string> lines(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const double north = box.high.x() - row * north_step;
    for (int column = 0; column < width; ++column) {
      lines[static_cast<std::size_t>(row)] +=
          LetterAt(shape, region, {north, box.low.y() + column * east_step});
    }
  }
  const auto put = [&](const PlanePoint& at, char letter) {
    const auto row = std::lround((box.high.x() - at.x()) / north_step);
    const auto column = std::lround((at.y() - box.low.y()) / east_step);
    lines[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = letter;
  };
  for (const PlanePoint& at : region.transit())
    put(at, 'o');
  if (site.start) put(*site.start, 'S');
  std::string text;
  for (std::string& line : lines) {
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
