// SPDX-License-Identifier: MIT
#include "limpet/survey/mission_area.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limpet/survey/survey_shape.hpp"

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
  if (!places) {
    return AreaProblem{.key = key,
                       .text = fmt::format("`{}` is no list of points; allowed: "
                                           "pts={{x,y:x,y:x,y}}, x east and y north [m]",
                                           text),
                       .is_unreadable = true};
  }
  return *places;
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

Expected<SurveyArea, AreaProblem> Outlined(const SurveyParams& params) {
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

}  // namespace

Expected<SurveyArea, AreaProblem> AreaOf(const SurveyParams& params) {
  auto area = params.area.empty() ? Rectangle(params) : Outlined(params);
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
