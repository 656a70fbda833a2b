// SPDX-License-Identifier: MIT
#include "limpet/survey/survey_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/require.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

constexpr double kCornerRounding = 0.02;  // of corners in text [m]
constexpr double kCountedCell = 0.25;

Expected<SimplePolygon> PolygonIn(std::string_view text, const std::string& what) {
  const auto places = ParsePlaces(text);
  if (!places) {
    return Error{fmt::format("{} is no list of points: `{}`; allowed: {{x,y:x,y:x,y}}", what,
                             text.substr(0, 80))};
  }
  Expected<SimplePolygon> polygon = SimplePolygon::Of(*places);
  if (!polygon) return Error{fmt::format("{} {}", what, polygon.error().text)};
  return polygon;
}

/// `{...}{...}` as its parts; a text without braces is one part.
std::vector<std::string_view> PartsOf(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('}'), text.size() - 1) + 1;
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return parts;
}

/// The rectangle of the area, or why there is none.
Expected<SimplePolygon> OutlineOf(const SurveyArea& area) {
  const PlanePoint low(area.north_min, area.east_min), high(area.north_max, area.east_max);
  // Written so that what is no number is refused, too.
  if (!((high - low).minCoeff() > 0.0) || !low.allFinite() || !high.allFinite()) {
    return Error{fmt::format("has no extent: north {:g} to {:g}, east {:g} to {:g} m", low.x(),
                             high.x(), low.y(), high.y())};
  }
  if (!area.outline) return SimplePolygon::Box(low, high);
  Expected<SimplePolygon> outline = PolygonIn(*area.outline, "`area`");
  if (outline && ((outline->low() - low).cwiseAbs().maxCoeff() > kCornerRounding ||
                  (outline->high() - high).cwiseAbs().maxCoeff() > kCornerRounding)) {
    return Error{fmt::format(
        "`area` does not fill north {:g} to {:g}, east {:g} to {:g} m, which are to be its box",
        low.x(), high.x(), low.y(), high.y())};
  }
  return outline;
}

}  // namespace

Expected<SurveyShape> SurveyShape::Of(const SurveyArea& area) {
  Expected<SimplePolygon> outline = OutlineOf(area);
  if (!outline) return outline.error();
  SurveyShape shape(*std::move(outline));
  shape.margin_ = area.margin;
  shape.is_plain_ = !area.outline && !area.keep_out && !area.operating_region && !area.transit;
  const std::string zones = area.keep_out.value_or("");
  for (const std::string_view part : PartsOf(zones)) {
    Expected<SimplePolygon> zone = PolygonIn(part, "`keep_out`");
    if (!zone) return zone.error();
    shape.zones_.push_back(*std::move(zone));
  }
  if (area.operating_region) {
    Expected<SimplePolygon> region = PolygonIn(*area.operating_region, "`operating_region`");
    if (!region) return region.error();
    shape.region_ = *std::move(region);
  }
  if (area.transit) {
    const auto places = ParsePlaces(*area.transit);
    if (!places) return Error{fmt::format("`transit` is no list of points: `{}`", *area.transit)};
    shape.transit_ = *places;
  }
  if (!shape.is_plain_ && shape.WantedArea() <= 0.0) {
    return Error{"has nothing to survey: `keep_out` holds all of it"};
  }
  return shape;
}

bool SurveyShape::Wants(const PlanePoint& at) const {
  if (is_plain_) return true;  // cells may reach over a rectangle's edge, and count
  return outline_.Contains(at) && std::ranges::none_of(zones_, [&at](const SimplePolygon& zone) {
           return zone.Contains(at);
         });
}

double SurveyShape::WantedArea() const {
  if (zones_.empty()) return outline_.Area();
  constexpr double kMostCounted = 2e5;
  const PlanePoint extent = outline_.high() - outline_.low();
  const double cell = std::max(kCountedCell, std::sqrt(extent.x() * extent.y() / kMostCounted));
  double counted = 0.0;
  for (double north = outline_.low().x() + 0.5 * cell; north < outline_.high().x(); north += cell) {
    for (double east = outline_.low().y() + 0.5 * cell; east < outline_.high().y(); east += cell) {
      counted += Wants({north, east}) ? cell * cell : 0.0;
    }
  }
  return counted;
}

double SurveyShape::OutsideArea(const PlanePoint& at) const {
  return std::max(0.0, -outline_.Depth(at));
}

std::string PlacesText(const std::vector<PlanePoint>& places) {
  std::vector<MapPoint> points;
  points.reserve(places.size());
  for (const PlanePoint& place : places)
    points.push_back(MapPointOf(place));
  return "{" + PointsText(points) + "}";
}

std::optional<std::vector<PlanePoint>> ParsePlaces(std::string_view text) {
  if (text.starts_with('{') && text.ends_with('}')) {
    text = text.substr(1, text.size() - 2);
  }
  const auto points = ParsePoints(text);
  if (!points || !BesidePoints(text).empty()) return std::nullopt;
  std::vector<PlanePoint> places;
  places.reserve(points->size());
  for (const MapPoint& point : *points)
    places.emplace_back(point.y, point.x);
  return places;
}

SurveyArea AreaWithin(const std::vector<PlanePoint>& outline) {
  LIMPET_REQUIRE(outline.size() >= 3, "an outline has three corners or more");
  const std::string text = PlacesText(outline);
  // The box is of the rounded corners, so that both say the same.
  const std::vector<PlanePoint> rounded = ParsePlaces(text).value_or(outline);
  PlanePoint low = rounded.front(), high = low;
  for (const PlanePoint& corner : rounded) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  SurveyArea area{
      .north_min = low.x(), .north_max = high.x(), .east_min = low.y(), .east_max = high.y()};
  area.outline = text;
  return area;
}

}  // namespace limpet
