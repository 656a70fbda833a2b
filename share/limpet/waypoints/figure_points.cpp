// SPDX-License-Identifier: MIT
#include "limpet/waypoints/figure_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "limpet/core/config.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/units.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {
namespace {

using Points = std::vector<MapPoint>;

constexpr double kMostPoints = 10'000.0;  ///< a figure is not to fill the memory

/// `a=1, b=2`, keys in lower case.
class Measures {
 public:
  /// Nothing if a part has no `=`.
  static std::optional<Measures> In(std::string_view text) {
    Measures measures;
    for (const std::string& part : Split(text, ',')) {
      const std::size_t equals = part.find('=');
      if (equals == std::string::npos) return std::nullopt;
      const std::string_view whole = part;
      measures.texts_[LowerCase(Trim(whole.substr(0, equals)))] = Trim(whole.substr(equals + 1));
    }
    return measures;
  }
  /// Those of `1, 2`, which go by their places; nothing if there are too few, or no numbers.
  template <std::size_t N>
  static std::optional<Measures> InOrder(std::string_view text,
                                         const std::array<const char*, N>& keys,
                                         std::size_t fewest) {
    Measures measures;
    const std::vector<std::string> parts = Split(text, ',');
    if (parts.size() < fewest || parts.size() > keys.size() + 1) return std::nullopt;
    for (std::size_t i = 0; i < std::min(parts.size(), keys.size()); ++i) {
      measures.texts_[keys[i]] = Trim(parts[i]);
      if (!measures.Number(keys[i])) return std::nullopt;
    }
    return measures;
  }

  [[nodiscard]] std::string Text(std::string_view key) const {
    const auto found = texts_.find(key);
    return found == texts_.end() ? "" : found->second;
  }
  [[nodiscard]] std::optional<double> Number(std::string_view key) const {
    return ParseNumber(Text(key));
  }
  /// The measure's value if it is above zero; nothing else.
  [[nodiscard]] std::optional<double> Length(std::string_view key) const {
    const std::optional<double> length = Number(key);
    return length && *length > 0.0 ? length : std::nullopt;
  }
  [[nodiscard]] std::optional<MapPoint> Place(std::string_view x, std::string_view y) const {
    const auto east = Number(x), north = Number(y);
    return east && north ? std::optional(MapPoint{*east, *north}) : std::nullopt;
  }
  /// A bearing [rad] that is given in compass degrees.
  [[nodiscard]] std::optional<double> Bearing(std::string_view key) const {
    const std::optional<double> degrees = Number(key);
    return degrees ? std::optional(RadiansFromDegrees(*degrees)) : std::nullopt;
  }
  /// How many corners, if there are `fewest`.
  [[nodiscard]] std::optional<int> Count(std::string_view key, double fewest) const {
    const std::optional<double> count = Number(key);
    return count && *count >= fewest && *count <= kMostPoints
               ? std::optional(static_cast<int>(*count))
               : std::nullopt;
  }

 private:
  std::map<std::string, std::string, std::less<>> texts_;
};

/// How far a point lies from a place, for who looks along some bearing [m].
struct Aside {
  double right, ahead;
};

MapPoint Beside(const MapPoint& place, double bearing, const Aside& by) {
  constexpr double kRightAngle = 0.5 * std::numbers::pi;
  return Project(Project(place, {.bearing = bearing, .distance = by.ahead}),
                 {.bearing = bearing + kRightAngle, .distance = by.right});
}

/// Lanes along `degs`, or across it where the rows go from east to west, from the left of it to the
/// right, the last one at the block's edge or beyond.
std::optional<Points> Lawnmower(const Measures& in) {
  const auto center = in.Place("x", "y");
  const auto height = in.Length("height"), width = in.Length("width");
  const auto lane = in.Length(in.Text("lane_width").empty() ? "swath" : "lane_width");
  if (!center || !height || !width || !lane) return std::nullopt;
  const std::string rows = in.Text("rows");
  const bool is_north_south = rows == "north-south" || rows == "ns";
  const double length = is_north_south ? *height : *width;
  const double breadth = is_north_south ? *width : *height;
  const double bearing =
      in.Bearing("degs").value_or(0.0) + (is_north_south ? 0.0 : 0.5 * std::numbers::pi);
  constexpr double kHair = 1e-5;  // a lane at the very edge counts
  const double lanes = std::floor(breadth / *lane + 2.0 - kHair);
  if (lanes > 0.5 * kMostPoints) return std::nullopt;
  const double last = 0.5 * breadth - (lanes - 1.0) * *lane;
  // The lanes' far and near ends; of the four corners the one at the start is the first.
  const auto end_at = [&](double left, double ahead) {
    return Beside(*center, bearing, {-left, 0.5 * length * ahead});
  };
  const MapPoint start = in.Place("startx", "starty").value_or(MapPoint{});
  const std::array corners{end_at(0.5 * breadth, 1.0), end_at(0.5 * breadth, -1.0),
                           end_at(last, 1.0), end_at(last, -1.0)};
  const auto nearest = std::ranges::min_element(
      corners, {}, [&start](const MapPoint& corner) { return DistanceBetween(start, corner); });
  const auto corner = nearest - corners.begin();
  double ahead = corner % 2 == 0 ? 1.0 : -1.0;
  Points points;
  for (int i = 0; i < static_cast<int>(lanes); ++i) {
    const double left = corner < 2 ? 0.5 * breadth - i * *lane : last + i * *lane;
    points.push_back(end_at(left, ahead));
    points.push_back(end_at(left, -ahead));
    ahead = -ahead;
  }
  return points;
}

/// Two loops beside each other, crossed in the middle; the last point lies on the start's side.
std::optional<Points> Bowtie(const Measures& in) {
  const auto center = in.Place("x", "y");
  const auto height = in.Number("height"), inner = in.Number("wid1"), outer = in.Number("wid2"),
             waist = in.Number("wid3");
  if (!center || !height || !inner || !outer || !waist) return std::nullopt;
  const MapPoint start = in.Place("startx", "starty").value_or(*center);
  const double east = start.x < center->x ? -1.0 : 1.0;
  const double north = start.y < center->y ? -1.0 : 1.0;
  Points points;
  for (const double side : {-east, east}) {
    const std::array<MapPoint, 5> loop{
        MapPoint{*inner, -0.5 * *height}, MapPoint{*outer, -0.5 * *height}, MapPoint{*waist, 0.0},
        MapPoint{*outer, 0.5 * *height}, MapPoint{*inner, 0.5 * *height}};
    for (const MapPoint& point : loop) {
      points.push_back({center->x + side * point.x, center->y + north * point.y});
    }
  }
  return points;
}

/// Points of a zigzag from side to side of a line, the left first.
std::optional<Points> Zigzag(const Measures& in) {
  const auto start = in.Place("x", "y");
  const auto angle = in.Bearing("angle");
  const auto length = in.Length("length"), period = in.Length("period"),
             amplitude = in.Length("amplitude");
  if (!start || !angle || !length || !period || !amplitude || *length / *period > kMostPoints / 4) {
    return std::nullopt;
  }
  Points points{*start};
  double side = -1.0;
  for (int i = 0; 0.25 * *period + 0.5 * i * *period < *length; ++i) {
    points.push_back(
        Beside(*start, *angle, {side * *amplitude, 0.25 * *period + 0.5 * i * *period}));
    side = -side;
  }
  return points;
}

/// A regular polygon with an edge, not a corner, north.
std::optional<Points> Radial(const Measures& in) {
  constexpr double kFewest = 3.0;
  const auto center = in.Place("x", "y");
  const auto radius = in.Length("radius");
  const auto count = in.Count("pts", kFewest);
  if (!center || !radius || !count) return std::nullopt;
  const MapPoint shifted{center->x + in.Number("shiftx").value_or(0.0),
                         center->y + in.Number("shifty").value_or(0.0)};
  Points points;
  for (int i = 0; i < *count; ++i) {
    points.push_back(Project(
        shifted, {.bearing = 2.0 * std::numbers::pi * (i + 0.5) / *count, .distance = *radius}));
  }
  return points;
}

/// Points of an ellipse from the far end of its long axis on; angles go from east to north.
std::optional<Points> Ellipse(const Measures& in) {
  constexpr double kFewest = 4.0;
  const auto center = in.Place("x", "y");
  const auto major = in.Length("major"), minor = in.Length("minor");
  const auto count = in.Count("pts", kFewest);
  const auto axis = in.Number("rads") ? in.Number("rads") : in.Bearing("degs");
  if (!center || !major || !minor || !count || !axis) return std::nullopt;
  Points points;
  for (int i = 0; i < *count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / *count - std::numbers::pi;
    const double along = 0.5 * *major * std::cos(angle), across = 0.5 * *minor * std::sin(angle);
    points.push_back({center->x + along * std::cos(*axis) - across * std::sin(*axis),
                      center->y + along * std::sin(*axis) + across * std::cos(*axis)});
  }
  return points;
}

/// Two half circles and the straights between them, `len` from tip to tip.
std::optional<Points> Oval(const Measures& in) {
  constexpr int kSteps = 12;  // of each half circle
  const auto center = in.Place("x", "y");
  const auto radius = in.Length("rad"), length = in.Length("len");
  const auto axis = in.Bearing("ang");
  if (!center || !radius || !length || !axis || *length < 2.0 * *radius) return std::nullopt;
  Points points;
  for (const double end : {1.0, -1.0}) {
    const MapPoint middle =
        Project(*center, {.bearing = *axis, .distance = end * (0.5 * *length - *radius)});
    const double first = *axis - end * 0.5 * std::numbers::pi;
    for (int i = 0; i <= kSteps; ++i) {
      points.push_back(
          Project(middle, {.bearing = first + i * std::numbers::pi / kSteps, .distance = *radius}));
    }
  }
  return points;
}

/// An apex, and an arc from its left to its right.
std::optional<Points> Wedge(const Measures& in) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const auto apex = in.Place("x", "y");
  const auto left = in.Bearing("lang"), right = in.Bearing("rang");
  const auto range = in.Length("range");
  if (!apex || !left || !right || !range) return std::nullopt;
  const int steps = in.Count("pts", 1.0).value_or(1);
  const double turns = (*right - *left) / kTurn;
  const double angle = kTurn * (turns - std::floor(turns));
  Points points{*apex};
  for (int i = 0; i <= steps; ++i) {
    points.push_back(Project(*apex, {.bearing = *left + angle * i / steps, .distance = *range}));
  }
  return points;
}

/// A rectangle about the line between two places.
std::optional<Points> Pylon(const Measures& in) {
  const auto first = in.Place("x1", "y1"), second = in.Place("x2", "y2");
  const auto along = in.Number("axis_pad"), across = in.Number("perp_pad");
  if (!first || !second || !along || !across || *along < 0.0 || *across < 0.0) return std::nullopt;
  const double axis = BearingTo(*first, *second);
  return Points{Beside(*first, axis, {-*across, -*along}), Beside(*first, axis, {*across, -*along}),
                Beside(*second, axis, {*across, *along}),
                Beside(*second, axis, {-*across, *along})};
}

std::optional<Points> Spot(const Measures& in) {
  const auto place = in.Place("x", "y");
  return place ? std::optional(Points{*place}) : std::nullopt;
}

struct Figure {
  std::string_view name;
  std::optional<Points> (*lay)(const Measures&);
};
constexpr std::array kFigures{Figure{"lawnmower", Lawnmower}, Figure{"bowtie", Bowtie},
                              Figure{"zigzag", Zigzag},       Figure{"radial", Radial},
                              Figure{"ellipse", Ellipse},     Figure{"oval", Oval},
                              Figure{"wedge", Wedge},         Figure{"piewedge", Wedge},
                              Figure{"pylon", Pylon},         Figure{"", Spot}};

std::optional<Measures> Read(std::string_view name, std::string_view text) {
  if (text.find('=') != std::string_view::npos) return Measures::In(text);
  constexpr std::array kZigzag{"x", "y", "angle", "length", "period", "amplitude", "snap"};
  constexpr std::array kRadial{"x", "y", "radius", "pts", "snap"};
  if (name == "zigzag") return Measures::InOrder(text, kZigzag, kZigzag.size() - 1);
  if (name == "radial") return Measures::InOrder(text, kRadial, kRadial.size() - 1);
  return std::nullopt;
}

void Snap(const Measures& in, Points& points) {
  const auto snap = in.Length("snap");
  if (!snap) return;
  for (MapPoint& point : points) {
    point = {*snap * std::round(point.x / *snap), *snap * std::round(point.y / *snap)};
  }
}

}  // namespace

std::optional<std::vector<MapPoint>> FigurePoints(std::string_view text) {
  std::string name;
  if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    name = Trim(text.substr(0, colon));
    text.remove_prefix(colon + (text.substr(colon).starts_with("::") ? 2 : 1));
  }
  const std::optional<Measures> measures = Read(name, text);
  if (!measures) return std::nullopt;
  if (name.empty()) name = measures->Text("format");
  const auto figure = std::ranges::find(kFigures, name, &Figure::name);
  if (figure == kFigures.end()) return std::nullopt;
  std::optional<Points> points = figure->lay(*measures);
  if (!points) return std::nullopt;
  Snap(*measures, *points);
  const bool is_on_map = std::ranges::all_of(
      *points, [](const MapPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  return is_on_map ? points : std::nullopt;
}

}  // namespace limpet
