// SPDX-License-Identifier: MIT
#include "limpet/survey/mission_area.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/survey/geo_area.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

using Bound = std::pair<const char*, const std::optional<Meters>*>;

std::array<Bound, 4> BoundsOf(const SurveyParams& params) {
  return {Bound{"area_north_min_m", &params.north_min},
          Bound{"area_north_max_m", &params.north_max}, Bound{"area_east_min_m", &params.east_min},
          Bound{"area_east_max_m", &params.east_max}};
}

/// The parameter's points, made the same text whatever form the mission gives them in.
Expected<std::vector<PlanePoint>, AreaProblem> PlacesOf(const char* key, const std::string& text) {
  const auto places = ParsePlaces(text);
  if (places) return *places;
  const std::string beside = BesidePoints(text);
  return AreaProblem{
      .key = key,
      .text =
          beside.empty()
              ? fmt::format("`{}` is no list of points; allowed: pts={{x,y:x,y:x,y}}, x east "
                            "and y north [m]{}",
                            text, text.find('{') != text.rfind('{') ? ", each on its own line" : "")
              : fmt::format("nothing would read `{}` beside the points; allowed: one "
                            "pts={{x,y:x,y:x,y}}, and each further polygon on its own line",
                            beside),
      .is_unreadable = true};
}

/// Keeps the places of a polygon as text; the problem, if it is none.
std::optional<AreaProblem> TakePolygon(const char* key, const std::string& given,
                                       std::optional<std::string>& text) {
  const auto places = PlacesOf(key, given);
  if (!places) return places.error();
  const auto polygon = SimplePolygon::Of(*places);
  if (!polygon) return AreaProblem{.key = key, .text = polygon.error().text};
  text = text.value_or("") + PlacesText(*places);
  return std::nullopt;
}

Expected<SurveyArea, AreaProblem> Rectangle(const SurveyParams& params) {
  for (const auto& [key, bound] : BoundsOf(params)) {
    if (!*bound) {
      return AreaProblem{.key = key,
                         .text =
                             "is missing in pSurvey and has no default; allowed: a number in m, "
                             "or `area` in place of all four edges",
                         .is_unreadable = true};
    }
  }
  return SurveyArea{.north_min = params.north_min->value(),
                    .north_max = params.north_max->value(),
                    .east_min = params.east_min->value(),
                    .east_max = params.east_max->value()};
}

Expected<SurveyArea, AreaProblem> OutlinedArea(const SurveyParams& params) {
  for (const auto& [key, bound] : BoundsOf(params)) {
    if (*bound) {
      return AreaProblem{.key = key,
                         .text = "is given beside `area`; allowed: one of the two",
                         .is_unreadable = true};
    }
  }
  const auto places = PlacesOf("area", params.area);
  if (!places) return places.error();
  const auto polygon = SimplePolygon::Of(*places);
  if (!polygon) return AreaProblem{.key = "area", .text = polygon.error().text};
  return AreaWithin(*places);
}

AreaProblem GeoProblem(const SurveyParams& params, const std::string& text) {
  return {.key = "area_geojson", .text = params.area_geojson + " " + text};
}

/// A ring of the file as a polygon's corners on the mission's grid.
Expected<std::vector<PlanePoint>, AreaProblem> CornersOf(const SurveyParams& params,
                                                         const std::vector<GeoPoint>& ring,
                                                         const GeoPoint& datum) {
  auto places = PlacesOnGrid(ring, datum);
  if (!places) return GeoProblem(params, places.error().text);
  const auto polygon = SimplePolygon::Of(*places);
  if (!polygon) return GeoProblem(params, polygon.error().text);
  return *std::move(places);
}

Expected<SurveyArea, AreaProblem> FromFile(const SurveyParams& params, const SiteGlobals& site) {
  const auto latitude = ParseNumber(site.latitude), longitude = ParseNumber(site.longitude);
  if (!latitude || !longitude) {
    return GeoProblem(params, "needs a datum: the mission says no LatOrigin and LongOrigin");
  }
  const std::filesystem::path file = site.folder / params.area_geojson;
  if (std::filesystem::is_directory(file)) {
    return GeoProblem(params, fmt::format("is a folder, {}; allowed: a GeoJSON or KML file",
                                          file.lexically_normal().string()));
  }
  std::ifstream in(file, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in.good() && text.empty()) return GeoProblem(params, "cannot be read");
  const auto geo = ParseGeoArea(text);
  if (!geo) return GeoProblem(params, geo.error().text);
  const GeoPoint datum{.latitude_deg = *latitude, .longitude_deg = *longitude};
  const auto outline = CornersOf(params, geo->outline, datum);
  if (!outline) return outline.error();
  SurveyArea area = AreaWithin(*outline);
  for (const std::vector<GeoPoint>& ring : geo->holes) {
    const auto hole = CornersOf(params, ring, datum);
    if (!hole) return hole.error();
    area.keep_out = area.keep_out.value_or("") + PlacesText(*hole);
  }
  return area;
}

/// The ground to be surveyed, by the one of three ways of saying it that the mission takes.
Expected<SurveyArea, AreaProblem> GroundOf(const SurveyParams& params, const SiteGlobals& site) {
  if (params.area_geojson.empty()) {
    return params.area.empty() ? Rectangle(params) : OutlinedArea(params);
  }
  bool is_said_twice = !params.area.empty();
  for (const auto& [key, bound] : BoundsOf(params))
    is_said_twice = is_said_twice || *bound;
  if (is_said_twice) {
    return AreaProblem{.key = "area_geojson",
                       .text = "is given beside `area` or its edges; allowed: one of them",
                       .is_unreadable = true};
  }
  return FromFile(params, site);
}

}  // namespace

Expected<SurveyArea, AreaProblem> AreaOf(const SurveyParams& params, const SiteGlobals& site) {
  auto area = GroundOf(params, site);
  if (!area) return area;
  area->margin = params.margin.value();
  area->object_height_max = params.object_height_max.value();
  for (const std::string& zone : params.keep_out) {
    if (auto problem = TakePolygon("keep_out", zone, area->keep_out)) return *std::move(problem);
  }
  if (!params.operating_region.empty()) {
    if (auto problem =
            TakePolygon("operating_region", params.operating_region, area->operating_region)) {
      return *std::move(problem);
    }
  }
  if (!params.transit.empty()) {
    const auto places = PlacesOf("transit", params.transit);
    if (!places) return places.error();
    area->transit = PlacesText(*places);
  }
  return area;
}

}  // namespace limpet
