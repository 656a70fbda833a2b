// SPDX-License-Identifier: MIT
#include "limpet/site/site_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limpet/planning/region.hpp"

namespace limpet {
namespace {

char LetterAt(const SurveyShape& shape, const Region& region, const PlanePoint& at) {
  const bool is_in_zone = std::ranges::any_of(
      shape.zones(), [&at](const SimplePolygon& zone) { return zone.Contains(at); });
  if (is_in_zone) return '#';
  if (shape.outline().Contains(at)) return ':';
  return region.Contains(at) ? '.' : ' ';
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
    const PlanePoint along = edge.to_W - edge.from_W;
    const auto pieces = std::max(1L, std::lround(2.0 * along.norm() / map.step.minCoeff()));
    for (long piece = 0; piece <= pieces; ++piece) {
      const PlanePoint at =
          edge.from_W + static_cast<double>(piece) / static_cast<double>(pieces) * along;
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

}  // namespace

std::string SiteText(const Site& site, int columns) {
  const SurveyShape shape = *SurveyShape::Of(site.area);
  const Region region(site.area);
  const SiteBox box = BoxAround(site);
  // A letter is about twice as high as wide.
  constexpr double kLetterShape = 2.0;
  constexpr int kMostRows = 50;
  const PlanePoint extent = box.high_W - box.low_W;
  const double east_step = std::max(extent.y() / columns, extent.x() / (kLetterShape * kMostRows));
  const double north_step = kLetterShape * east_step;
  const int rows = static_cast<int>(std::ceil(extent.x() / north_step)) + 1;
  const int width = static_cast<int>(std::ceil(extent.y() / east_step)) + 1;
  LetterMap map{
      .corner = {box.high_W.x(), box.low_W.y()},
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
  if (site.start_W) map.At(*site.start_W) = 'S';
  std::string text;
  for (std::string& line : map.lines) {
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text + LegendText(text) + site.Summary() + "\n";
}

}  // namespace limpet
