// SPDX-License-Identifier: MIT
#include "limpet/waypoints/point_list.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "limpet/core/config.hpp"
#include "limpet/core/decimal_text.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/units.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

constexpr std::size_t kMostPoints = 10'000;  ///< a generator is not to fill the memory

using Fields = std::map<std::string, std::string, std::less<>>;

std::optional<MapPoint> Pair(std::string_view text) {
  const std::vector<std::string> parts = Split(text, ',');
  if (parts.size() != 2 && parts.size() != 3) return std::nullopt;
  const auto x = ParseNumber(Trim(parts[0])), y = ParseNumber(Trim(parts[1]));
  return x && y ? std::optional<MapPoint>({*x, *y}) : std::nullopt;
}

std::optional<std::vector<MapPoint>> Pairs(std::string_view text) {
  std::vector<MapPoint> points;
  for (const std::string& part : Split(text, ':')) {
    const auto point = Pair(part);
    if (!point) return std::nullopt;
    points.push_back(*point);
  }
  return points;
}

/// `a=1, b=2` with keys in lower case; nothing if a part has no `=`.
std::optional<Fields> FieldsOf(std::string_view text) {
  Fields fields;
  for (const std::string& part : Split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return std::nullopt;
    std::string key(Trim(std::string_view(part).substr(0, equals)));
    std::ranges::transform(key, key.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    fields[key] = Trim(std::string_view(part).substr(equals + 1));
  }
  return fields;
}

std::string TextIn(const Fields& fields, std::string_view key) {
  const auto found = fields.find(key);
  return found == fields.end() ? "" : found->second;
}

std::optional<double> NumberIn(const Fields& fields, std::string_view key) {
  return ParseNumber(TextIn(fields, key));
}

/// A place of a figure's own frame, `ahead` along its first axis, turned clockwise by `turn` [rad].
MapPoint Placed(const MapPoint& center, double right, double ahead, double turn) {
  return {.x = center.x + right * std::cos(turn) + ahead * std::sin(turn),
          .y = center.y - right * std::sin(turn) + ahead * std::cos(turn)};
}

std::optional<std::vector<MapPoint>> Ring(const Fields& fields, bool is_ellipse) {
  constexpr double kFewest = 3.0;
  const auto x = NumberIn(fields, "x"), y = NumberIn(fields, "y"), count = NumberIn(fields, "pts");
  const auto major = NumberIn(fields, is_ellipse ? "major" : "radius");
  const auto minor = is_ellipse ? NumberIn(fields, "minor") : major;
  if (!x || !y || !count || !major || !minor || *major <= 0.0 || *minor <= 0.0 ||
      *count < kFewest || *count > static_cast<double>(kMostPoints)) {
    return std::nullopt;
  }
  // The long axis of an ellipse lies along `degs`; a radial figure has an edge, not a corner,
  // north.
  const double turn = is_ellipse ? RadiansFromDegrees(NumberIn(fields, "degs").value_or(0.0)) : 0.0;
  const double snap = NumberIn(fields, "snap").value_or(0.0);
  const int corners = static_cast<int>(*count);
  const double step = 2.0 * std::numbers::pi / corners;
  std::vector<MapPoint> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + (is_ellipse ? 0.0 : 0.5)) * step;
    const double half_scale = is_ellipse ? 0.5 : 1.0;
    MapPoint point = Placed({*x, *y}, half_scale * *minor * std::sin(angle),
                            half_scale * *major * std::cos(angle), turn);
    if (snap > 0.0) {
      point = {snap * std::round(point.x / snap), snap * std::round(point.y / snap)};
    }
    points.push_back(point);
  }
  return points;
}

std::optional<std::vector<MapPoint>> Lawnmower(const Fields& fields) {
  const auto x = NumberIn(fields, "x"), y = NumberIn(fields, "y");
  const auto height = NumberIn(fields, "height"), width = NumberIn(fields, "width");
  const auto lane_key = fields.contains("lane_width") ? "lane_width" : "swath";
  const auto lane = NumberIn(fields, lane_key);
  if (!x || !y || !height || !width || !lane || *height <= 0.0 || *width <= 0.0 || *lane <= 0.0) {
    return std::nullopt;
  }
  std::string rows = TextIn(fields, "rows");
  const bool is_east_west = rows == "east-west" || rows == "ew";
  const double length = is_east_west ? *width : *height;
  const double breadth = is_east_west ? *height : *width;
  const double lanes = std::floor(breadth / *lane) + 1.0;
  if (lanes > static_cast<double>(kMostPoints) / 2.0) return std::nullopt;
  const double turn = RadiansFromDegrees(NumberIn(fields, "degs").value_or(0.0));
  std::vector<MapPoint> points;
  for (int i = 0; i < static_cast<int>(lanes); ++i) {
    const double across = (i - 0.5 * (lanes - 1.0)) * *lane;
    for (const double along : {-0.5 * length, 0.5 * length}) {
      const double ahead = i % 2 == 0 ? along : -along;
      points.push_back(is_east_west ? Placed({*x, *y}, ahead, across, turn)
                                    : Placed({*x, *y}, across, ahead, turn));
    }
  }
  const auto start_x = NumberIn(fields, "startx"), start_y = NumberIn(fields, "starty");
  if (start_x && start_y) {  // begin at the end that is nearer
    const MapPoint start{*start_x, *start_y};
    if (DistanceBetween(start, points.back()) < DistanceBetween(start, points.front())) {
      std::ranges::reverse(points);
    }
  }
  return points;
}

std::optional<std::vector<MapPoint>> Generated(std::string_view text) {
  std::string format;
  if (const std::size_t colons = text.find("::"); colons != std::string_view::npos) {
    format = Trim(text.substr(0, colons));
    text = text.substr(colons + 2);
  }
  const std::optional<Fields> fields = FieldsOf(text);
  if (!fields) return std::nullopt;
  if (format.empty()) format = TextIn(*fields, "format");
  if (format == "lawnmower") return Lawnmower(*fields);
  if (format == "radial") return Ring(*fields, false);
  if (format == "ellipse") return Ring(*fields, true);
  const auto x = NumberIn(*fields, "x"), y = NumberIn(*fields, "y");
  if (format.empty() && x && y) return std::vector<MapPoint>{{*x, *y}};
  return std::nullopt;
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
  if (text.find('=') != std::string_view::npos) return Generated(text);
  return Pairs(text);
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
