// SPDX-License-Identifier: MIT
#include "limpet/survey/geo_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "limpet/core/config.hpp"
#include "limpet/core/harmless_text.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

using Json = nlohmann::json;
using Ring = std::vector<GeoPoint>;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kWideLittle = "\xFF\xFE", kWideBig = "\xFE\xFF";  ///< of UTF-16
constexpr std::string_view kZip = "PK\x03\x04";

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

/// The file's frame, if it names another than GeoJSON's: its numbers would be taken for degrees.
std::optional<Error> ProblemOfFrame(const Json& json) {
  constexpr std::array kKnown{"CRS84", "EPSG:4326", "EPSG::4326", "WGS84", "WGS 84", "WGS_84"};
  constexpr auto kLenient = Json::error_handler_t::replace;
  const Json& frame = json.is_object() ? MemberOf(json, "crs") : json;
  if (!json.is_object() || frame.is_null()) return std::nullopt;
  const Json& properties = frame.is_object() ? MemberOf(frame, "properties") : frame;
  const Json& said = properties.is_object() ? MemberOf(properties, "name") : properties;
  const std::string name =
      said.is_string() ? said.get<std::string>() : frame.dump(-1, ' ', true, kLenient);
  if (std::ranges::any_of(kKnown, [&](const char* known) { return name.ends_with(known); })) {
    return std::nullopt;
  }
  return Error{fmt::format("is in the frame (crs) {}; allowed: WGS84 alone, in degrees",
                           HarmlessText(name.substr(0, 80)))};
}

/// Takes every polygon of a GeoJSON object, however deep it lies: one that were passed over would
/// be a part of the site that nobody surveys.
class PolygonWalk {
 public:
  explicit PolygonWalk(std::vector<GeoPolygon>& polygons) : polygons_(polygons) {}

  /// `where`: the object's place in the file, empty at the top.
  std::optional<Error> Take(const Json& json, const std::string& where, int depth = 0) {
    constexpr int kDeepest = 20;
    constexpr std::array kOthers{"Point", "MultiPoint", "LineString", "MultiLineString"};
    const std::string type = TypeOf(json);
    if (auto problem = ProblemOfFrame(json)) return problem;
    if (depth > kDeepest) return Error{"has collections in one another, deeper than any site"};
    if (type == "FeatureCollection") return TakeEach(json, "features", where, depth);
    if (type == "GeometryCollection") return TakeEach(json, "geometries", where, depth);
    if (type == "Feature") {
      const Json& geometry = MemberOf(json, "geometry");
      return geometry.is_null() ? std::nullopt
                                : Take(geometry, Below(where, "geometry"), depth + 1);
    }
    if (type == "Polygon") return AddPolygon(MemberOf(json, "coordinates"), polygons_);
    if (type == "MultiPolygon") return TakeParts(MemberOf(json, "coordinates"));
    if (std::ranges::find(kOthers, type) != kOthers.end()) return std::nullopt;
    return Unknown(type, where);
  }

 private:
  static std::string Below(const std::string& where, const std::string& member) {
    return where.empty() ? member : where + "." + member;
  }

  static Error Unknown(const std::string& type, const std::string& where) {
    const std::vector<std::string> known{"FeatureCollection", "Feature", "GeometryCollection",
                                         "Polygon", "MultiPolygon"};
    const std::string nearest = NearestWord(type, known);
    const std::string place = where.empty() ? "an object at its top" : "`" + where + "`";
    return Error{
        type.empty()
            ? fmt::format("has {} without a `type`: nobody knows whether it is of the site", place)
            : fmt::format(
                  "has {} of the type `{}`, which GeoJSON has not{}", place,
                  HarmlessText(type.substr(0, 40)),
                  nearest.empty() ? "" : fmt::format("; nearest that it has: `{}`", nearest))};
  }

  std::optional<Error> TakeEach(const Json& json, const char* member, const std::string& where,
                                int depth) {
    const Json& list = MemberOf(json, member);
    const std::string place = Below(where, member);
    if (!list.is_array()) return Error{fmt::format("has `{}`, which is no list", place)};
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (auto problem = Take(list[i], fmt::format("{}[{}]", place, i), depth + 1)) return problem;
    }
    return std::nullopt;
  }

  std::optional<Error> TakeParts(const Json& parts) {
    if (!parts.is_array()) return Error{"has a MultiPolygon without polygons"};
    for (const Json& rings : parts) {
      if (auto problem = AddPolygon(rings, polygons_)) return problem;
    }
    return std::nullopt;
  }

  std::vector<GeoPolygon>& polygons_;
};

Expected<std::vector<GeoPolygon>> PolygonsOfJson(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return Error{"is no JSON"};
  std::vector<GeoPolygon> polygons;
  PolygonWalk walk(polygons);
  if (json.is_array()) {  // no GeoJSON, but what is in it shall not be called nothing
    for (std::size_t i = 0; i < json.size(); ++i) {
      if (!json[i].is_object()) continue;
      if (auto error = walk.Take(json[i], fmt::format("[{}]", i))) return *error;
    }
  } else if (auto error = walk.Take(json, "")) {
    return *error;
  }
  return polygons;
}

/// All elements of a name below `node`, whatever the prefix of its namespace.
pugi::xpath_node_set ElementsIn(const pugi::xml_node& node, const std::string& name) {
  return node.select_nodes((".//*[local-name()='" + name + "']").c_str());
}

/// All of it: a comment or a CDATA section in it parts it.
std::string TextIn(const pugi::xml_node& element) {
  std::string text;
  for (const pugi::xml_node& part : element.children()) {
    const bool is_text = part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata;
    if (is_text) text += part.value();
  }
  return text;
}

/// `longitude,latitude[,altitude]`, apart by blanks and line ends.
Expected<Ring> RingOfKml(const pugi::xml_node& boundary) {
  const pugi::xpath_node_set found = ElementsIn(boundary, "coordinates");
  if (found.size() != 1) {
    return Error{fmt::format("has a boundary with {} lists of coordinates", found.size())};
  }
  Ring ring;
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::string text = TextIn(found[0].node());
  std::string_view rest = text;
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

Expected<GeoPolygon> PolygonOfKml(const pugi::xml_node& element) {
  const pugi::xpath_node_set outer = ElementsIn(element, "outerBoundaryIs");
  if (outer.size() != 1) {
    return Error{fmt::format("has a polygon with {} outer boundaries", outer.size())};
  }
  Expected<Ring> outline = RingOfKml(outer[0].node());
  if (!outline) return outline.error();
  GeoPolygon polygon{.outline = *std::move(outline), .holes = {}};
  for (const pugi::xpath_node& inner : ElementsIn(element, "innerBoundaryIs")) {
    Expected<Ring> hole = RingOfKml(inner.node());
    if (!hole) return hole.error();
    polygon.holes.push_back(*std::move(hole));
  }
  return polygon;
}

Expected<std::vector<GeoPolygon>> PolygonsOfKml(std::string_view text) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
  if (!parsed) {
    return Error{fmt::format("is no XML: {}, after {} bytes", parsed.description(), parsed.offset)};
  }
  std::vector<GeoPolygon> polygons;
  for (const pugi::xpath_node& element : ElementsIn(document, "Polygon")) {
    Expected<GeoPolygon> polygon = PolygonOfKml(element.node());
    if (!polygon) return polygon.error();
    polygons.push_back(*std::move(polygon));
  }
  return polygons;
}

}  // namespace

Expected<GeoPolygon> ParseGeoArea(std::string_view text) {
  if (text.starts_with(kZip)) {
    return Error{"is a ZIP archive (KMZ); allowed: the .kml file that is in it, unpacked"};
  }
  const std::string_view first = text.substr(0, 2);
  const bool is_of_wide_letters = first == kWideLittle || first == kWideBig ||
                                  (first.size() == 2 && (first[0] == '\0') != (first[1] == '\0') &&
                                   first.find_first_of("{<[") != std::string_view::npos);
  if (is_of_wide_letters) return Error{"is written in UTF-16; allowed: UTF-8"};
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
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
    if (!place || place->norm() > kFarthestSite) {
      return Error{fmt::format(
          "has a corner at latitude {:g}, longitude {:g}, {}{:.0f} km from the mission's LatOrigin "
          "{:g}, "
          "LongOrigin {:g}; allowed: up to {:g} km (is longitude first in the file?)",
          corner.latitude_deg, corner.longitude_deg,
          place ? "" : "on the other side of the earth, ", DistanceBetween(datum, corner) / 1e3,
          datum.latitude_deg, datum.longitude_deg, kFarthestSite / 1e3)};
    }
    places.push_back(*place);
  }
  return places;
}

}  // namespace limpet
