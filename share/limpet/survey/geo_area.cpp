// SPDX-License-Identifier: MIT
#include "limpet/survey/geo_area.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

using Json = nlohmann::json;
using Ring = std::vector<GeoPoint>;

constexpr std::size_t kMostPolygons = 100;
constexpr double kFarthest = 20e3;  ///< from the datum [m]

bool IsOnEarth(const GeoPoint& at) {
  // Written so that what is no number is refused.
  return std::abs(at.latitude_deg) <= 90.0 && std::abs(at.longitude_deg) <= 180.0;
}

/// Longitude first, as both formats have it.
Expected<GeoPoint> PlaceOf(double longitude, double latitude) {
  const GeoPoint at{.latitude_deg = latitude, .longitude_deg = longitude};
  if (!IsOnEarth(at)) {
    return Error{
        fmt::format("longitude {:g}, latitude {:g} is no place on earth", longitude, latitude)};
  }
  return at;
}

void Open(Ring& ring) {
  const auto is_same = [](const GeoPoint& a, const GeoPoint& b) {
    return a.latitude_deg == b.latitude_deg && a.longitude_deg == b.longitude_deg;
  };
  if (ring.size() > 1 && is_same(ring.front(), ring.back())) ring.pop_back();
}

Expected<Ring> RingOf(const Json& json) {
  Ring ring;
  if (!json.is_array()) return Error{"has a ring that is no list"};
  for (const Json& place : json) {
    const bool is_place =
        place.is_array() && place.size() >= 2 && place[0].is_number() && place[1].is_number();
    if (!is_place) return Error{"has a corner that is not [longitude, latitude]"};
    const auto at = PlaceOf(place[0].get<double>(), place[1].get<double>());
    if (!at) return at.error();
    ring.push_back(*at);
  }
  Open(ring);
  return ring;
}

/// Adds the polygon that a list of rings is.
std::optional<Error> AddPolygon(const Json& rings, std::vector<GeoPolygon>& polygons) {
  if (!rings.is_array() || rings.empty()) return Error{"has a polygon without rings"};
  GeoPolygon polygon;
  for (const Json& json : rings) {
    Expected<Ring> ring = RingOf(json);
    if (!ring) return ring.error();
    if (&json == &rings[0]) {
      polygon.outline = *std::move(ring);
    } else {
      polygon.holes.push_back(*std::move(ring));
    }
  }
  polygons.push_back(std::move(polygon));
  return std::nullopt;
}

std::string TypeOf(const Json& json) {
  const auto type = json.is_object() ? json.find("type") : json.end();
  return json.is_object() && type != json.end() && type->is_string() ? type->get<std::string>()
                                                                     : "";
}

/// A member of an object, or null.
const Json& MemberOf(const Json& json, const char* name) {
  static const Json kNull;
  const auto found = json.find(name);
  return found == json.end() ? kNull : *found;
}

std::optional<Error> AddGeometry(const Json& json, std::vector<GeoPolygon>& polygons) {
  const Json& coordinates = json.is_object() ? MemberOf(json, "coordinates") : json;
  if (TypeOf(json) == "Polygon") return AddPolygon(coordinates, polygons);
  if (TypeOf(json) == "MultiPolygon" && coordinates.is_array()) {
    for (const Json& rings : coordinates) {
      if (auto error = AddPolygon(rings, polygons)) return error;
    }
  }
  return std::nullopt;  // points and lines are other things on the map
}

Expected<std::vector<GeoPolygon>> PolygonsOfJson(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return Error{"is no JSON"};
  std::vector<GeoPolygon> polygons;
  std::optional<Error> error;
  if (TypeOf(json) == "FeatureCollection" && MemberOf(json, "features").is_array()) {
    for (const Json& feature : MemberOf(json, "features")) {
      if (TypeOf(feature) != "Feature" || error) continue;
      error = AddGeometry(MemberOf(feature, "geometry"), polygons);
    }
  } else if (TypeOf(json) == "Feature") {
    error = AddGeometry(MemberOf(json, "geometry"), polygons);
  } else {
    error = AddGeometry(json, polygons);
  }
  if (error) return *error;
  return polygons;
}

/// What stands between `<name>` and `</name>`, from `at` on, which goes behind it; nothing if there
/// is no such element. Attributes are passed over.
std::optional<std::string_view> ElementIn(std::string_view text, std::string_view name,
                                          std::size_t& at) {
  const std::string opening = "<" + std::string(name), closing = "</" + std::string(name) + ">";
  for (std::size_t begin = text.find(opening, at); begin != std::string_view::npos;
       begin = text.find(opening, begin + 1)) {
    const std::size_t after = begin + opening.size();
    if (after >= text.size() || (text[after] != '>' && text[after] != ' ')) continue;
    const std::size_t inside = text.find('>', after);
    const std::size_t end = inside == std::string_view::npos ? inside : text.find(closing, inside);
    if (end == std::string_view::npos) return std::nullopt;
    at = end + closing.size();
    return text.substr(inside + 1, end - inside - 1);
  }
  return std::nullopt;
}

/// `longitude,latitude[,altitude]`, apart by blanks and line ends.
Expected<Ring> RingOfKml(std::string_view boundary) {
  std::size_t at = 0;
  const auto coordinates = ElementIn(boundary, "coordinates", at);
  if (!coordinates) return Error{"has a boundary without coordinates"};
  Ring ring;
  constexpr std::string_view kBlanks = " \t\r\n";
  std::string_view rest = *coordinates;
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    if (rest.empty()) break;
    const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
    rest.remove_prefix(word.size());
    const std::vector<std::string> parts = Split(word, ',');
    const auto longitude = ParseNumber(parts[0]);
    const auto latitude = parts.size() >= 2 ? ParseNumber(parts[1]) : std::nullopt;
    if (!longitude || !latitude) return Error{"has a corner that is not longitude,latitude"};
    const auto place = PlaceOf(*longitude, *latitude);
    if (!place) return place.error();
    ring.push_back(*place);
  }
  Open(ring);
  return ring;
}

Expected<std::vector<GeoPolygon>> PolygonsOfKml(std::string_view text) {
  std::vector<GeoPolygon> polygons;
  std::size_t at = 0;
  while (const auto element = ElementIn(text, "Polygon", at)) {
    if (polygons.size() >= kMostPolygons) break;  // too many in any case
    std::size_t inside = 0;
    const auto outer = ElementIn(*element, "outerBoundaryIs", inside);
    if (!outer) return Error{"has a polygon without an outer boundary"};
    Expected<Ring> outline = RingOfKml(*outer);
    if (!outline) return outline.error();
    GeoPolygon polygon{.outline = *std::move(outline), .holes = {}};
    inside = 0;
    while (const auto inner = ElementIn(*element, "innerBoundaryIs", inside)) {
      Expected<Ring> hole = RingOfKml(*inner);
      if (!hole) return hole.error();
      polygon.holes.push_back(*std::move(hole));
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

}  // namespace

Expected<GeoPolygon> ParseGeoArea(std::string_view text) {
  text = Trim(text);
  auto polygons = text.starts_with('<') ? PolygonsOfKml(text) : PolygonsOfJson(text);
  if (!polygons) return polygons.error();
  if (polygons->size() != 1) {
    return Error{fmt::format("has {} polygons; allowed: one, the area", polygons->size())};
  }
  return std::move(polygons->front());
}

Expected<std::vector<PlanePoint>> PlacesOnGrid(const std::vector<GeoPoint>& ring,
                                               const GeoPoint& datum) {
  const LocalGrid grid(datum);
  std::vector<PlanePoint> places;
  for (const GeoPoint& corner : ring) {
    const std::optional<PlanePoint> place = grid.Above(corner);
    if (!place || place->norm() > kFarthest) {
      return Error{fmt::format(
          "has a corner at latitude {:g}, longitude {:g}, {} from the mission's LatOrigin {:g}, "
          "LongOrigin {:g}; allowed: up to {:g} km (is longitude first in the file?)",
          corner.latitude_deg, corner.longitude_deg,
          place ? fmt::format("{:.0f} km", place->norm() / 1e3) : "on the other side of the earth",
          datum.latitude_deg, datum.longitude_deg, kFarthest / 1e3)};
    }
    places.push_back(*place);
  }
  return places;
}

}  // namespace limpet
