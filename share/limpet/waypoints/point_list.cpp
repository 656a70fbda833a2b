// SPDX-License-Identifier: MIT
#include "limpet/waypoints/point_list.hpp"

#include <algorithm>
#include <array>

#include "limpet/core/config.hpp"
#include "limpet/core/decimal_text.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/waypoints/figure_points.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

/// `x=` and the like in front of a coordinate.
std::string_view WithoutAxis(std::string_view text, char axis) {
  text = Trim(text);
  const bool is_named = text.size() >= 2 && text[0] == axis && text[1] == '=';
  return is_named ? text.substr(2) : text;
}

std::optional<MapPoint> Pair(std::string_view text) {
  constexpr std::size_t kMost = 4;  // with a height and a property, which are left out
  const std::vector<std::string> parts = Split(text, ',');
  if (parts.size() < 2 || parts.size() > kMost) return std::nullopt;
  const auto x = ParseNumber(WithoutAxis(parts[0], 'x')),
             y = ParseNumber(WithoutAxis(parts[1], 'y'));
  return x && y ? std::optional<MapPoint>({*x, *y}) : std::nullopt;
}

/// A word for how a list of points is drawn, not where.
bool IsDrawingWord(std::string_view word) {
  constexpr std::array kWords{"label", "source", "type", "msg", "active", "time", "duration"};
  constexpr std::array kEndings{"_color", "_size", "_transparency"};
  return std::ranges::any_of(kWords, [&](const char* w) { return EqualsIgnoringCase(word, w); }) ||
         std::ranges::any_of(kEndings, [&](const char* end) { return word.ends_with(end); });
}

/// `label,transit` and the like between points.
bool IsOfDrawing(std::string_view text) {
  const std::size_t comma = text.find(',');
  return comma != std::string_view::npos && IsDrawingWord(Trim(text.substr(0, comma)));
}

/// A text with points in braces: where they begin and end, and what is beside them.
struct BracedPoints {
  std::string_view before, points, behind;
};
/// Nothing if no `pts={...}` is whole.
std::optional<BracedPoints> BracedPointsIn(std::string_view text) {
  constexpr std::string_view kOpening = "pts={";
  const std::size_t begin = text.find(kOpening);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t end = text.find('}', begin);
  if (end == std::string_view::npos) return std::nullopt;
  const std::size_t inside = begin + kOpening.size();
  return BracedPoints{.before = text.substr(0, begin),
                      .points = text.substr(inside, end - inside),
                      .behind = text.substr(end + 1)};
}

std::string_view WithoutQuotes(std::string_view text) {
  text = Trim(text);
  const bool is_quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return is_quoted ? Trim(text.substr(1, text.size() - 2)) : text;
}

std::optional<std::vector<MapPoint>> Pairs(std::string_view text) {
  std::vector<MapPoint> points;
  for (const std::string& part : Split(text, ':')) {
    if (IsOfDrawing(part)) continue;
    const auto point = Pair(part);
    if (!point) return std::nullopt;
    points.push_back(*point);
  }
  if (points.empty()) return std::nullopt;
  return points;
}

}  // namespace

std::optional<std::vector<MapPoint>> ParsePoints(std::string_view text) {
  text = WithoutQuotes(text);
  if (text.find("pts={") != std::string_view::npos) {
    const auto braced = BracedPointsIn(text);
    // Of two polygons the second would be lost: a zone, e.g., that is then flown into.
    const bool is_one = braced && braced->behind.find("pts=") == std::string_view::npos;
    return is_one ? Pairs(braced->points) : std::nullopt;
  }
  for (const std::string_view word : {"pts:", "points:"}) {
    if (text.starts_with(word)) text.remove_prefix(word.size());
  }
  // A figure is named by a word, points begin with a number, or say how they are drawn.
  if (auto points = Pairs(text)) return points;
  return FigurePoints(text);
}

std::string BesidePoints(std::string_view text) {
  const auto braced = BracedPointsIn(WithoutQuotes(text));
  if (!braced) return "";
  for (const std::string_view side : {braced->before, braced->behind}) {
    for (const std::string& part : Split(side, ',')) {
      const std::string_view said = Trim(part);
      const std::size_t equals = said.find('=');
      const bool is_read = said.empty() || (equals != std::string_view::npos &&
                                            IsDrawingWord(Trim(said.substr(0, equals))));
      if (!is_read) return std::string(Trim(side));
    }
  }
  return "";
}

std::optional<MapPoint> ParsePoint(std::string_view text) {
  const auto points = ParsePoints(text);
  return points && points->size() == 1 ? std::optional(points->front()) : std::nullopt;
}

std::string PointsText(const std::vector<MapPoint>& points) {
  constexpr int kDecimals = 2;
  std::string text;
  for (const MapPoint& point : points) {
    text += (text.empty() ? "" : ":") + DecimalText(point.x, kDecimals) + "," +
            DecimalText(point.y, kDecimals);
  }
  return text;
}

std::vector<MapPoint> GreedyTour(std::vector<MapPoint> points, MapPoint start) {
  for (auto next = points.begin(); next != points.end(); ++next) {
    const auto nearest = std::ranges::min_element(
        next, points.end(), {},
        [&start](const MapPoint& point) { return DistanceBetween(start, point); });
    std::iter_swap(next, nearest);
    start = *next;
  }
  return points;
}

}  // namespace limpet
