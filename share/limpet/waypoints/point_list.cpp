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

/// `label,transit` and the like between points: how they are drawn.
bool IsOfDrawing(std::string_view text) {
  constexpr std::array kWords{"label", "source", "type", "msg", "active", "time", "duration"};
  const std::string_view word = Trim(text.substr(0, text.find(',')));
  return text.find(',') != std::string_view::npos &&
         (std::ranges::any_of(kWords, [&](const char* w) { return EqualsIgnoringCase(word, w); }) ||
          word.ends_with("_color") || word.ends_with("_size"));
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
  text = Trim(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = Trim(text.substr(1, text.size() - 2));
  }
  if (const std::size_t begin = text.find("pts={"); begin != std::string_view::npos) {
    constexpr std::size_t kOpening = 5;  // letters of `pts={`
    const std::size_t end = text.find('}', begin);
    if (end == std::string_view::npos) return std::nullopt;
    return Pairs(text.substr(begin + kOpening, end - begin - kOpening));
  }
  for (const std::string_view word : {"pts:", "points:"}) {
    if (text.starts_with(word)) text.remove_prefix(word.size());
  }
  // A figure is named by a word, points begin with a number, or say how they are drawn.
  if (auto points = Pairs(text)) return points;
  return FigurePoints(text);
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
