// SPDX-License-Identifier: MIT
#include "limpet/survey/requested_area.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/record.hpp"
#include "limpet/survey/band_top.hpp"
#include "limpet/survey/geo_area.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/topics/area_request.hpp"

namespace limpet {
namespace {

/// The names that a record describes.
struct FieldNames {
  std::vector<std::string> names;
  template <class Field>
  void operator()(const char* name, const Field&) {
    names.emplace_back(name);
  }
};

/// Keys of `key=value,key=value`, less what stands in braces; a value without a key as `{...}`.
std::vector<std::string> KeysIn(std::string_view text) {
  std::string outside;
  int depth = 0;
  for (const char letter : text) {
    depth += letter == '{' ? 1 : 0;
    if (depth == 0 || (depth == 1 && letter == '{')) outside += letter;
    depth -= letter == '}' && depth > 0 ? 1 : 0;
  }
  std::vector<std::string> keys;
  for (const std::string& part : Split(outside, ',')) {
    const std::string_view key = Trim(std::string_view(part).substr(0, part.find('=')));
    if (!key.empty()) keys.emplace_back(key.starts_with('{') ? "{...}" : key);
  }
  return keys;
}

/// A key that nothing knows would be passed over in silence: a zone of that name, e.g., flown into.
std::optional<Error> ProblemOfKeys(std::string_view text) {
  FieldNames known;
  SurveyAreaRequest().Describe(known);
  const std::vector<std::string> keys = KeysIn(text);
  for (const std::string& key : keys) {
    if (key == "{...}") {
      return Error{"a `{...}` stands without its key; several zones are keep_out={..}{..}"};
    }
    if (std::ranges::find(known.names, key) == known.names.end()) {
      const std::string nearest = NearestWord(key, known.names);
      return Error{fmt::format("nothing knows `{}`; {}", key,
                               nearest.empty()
                                   ? fmt::format("allowed: {}", fmt::join(known.names, ", "))
                                   : fmt::format("nearest known: `{}`", nearest))};
    }
    if (std::ranges::count(keys, key) > 1) return Error{fmt::format("`{}` is said twice", key)};
  }
  return std::nullopt;
}

/// What pSurvey's block would not be allowed to say.
std::optional<Error> ProblemOfNumbers(const SurveyAreaRequest& request,
                                      const AreaSetting& setting) {
  SurveyParams allowed;
  const std::vector<ParamSpec> specs = DescribeParams(allowed);
  const auto problem = [&specs](const char* key,
                                const std::optional<double>& value) -> std::optional<Error> {
    const auto spec = std::ranges::find(specs, key, &ParamSpec::name);
    const auto complaint = value ? spec->set(TextOf(*value)) : std::nullopt;
    return complaint ? std::optional(Error{fmt::format("{}: {}", key, *complaint)}) : std::nullopt;
  };
  if (auto error = problem("margin_m", request.margin)) return error;
  if (auto error = problem("object_height_max_m", request.object_height_max)) return error;
  if (!request.object_height_max) return std::nullopt;
  const double altitude = setting.params.altitude.value();
  const auto reason = ProblemOf(BandView{.object_height_max = *request.object_height_max,
                                         .object_radius = setting.object_radius.value(),
                                         .altitude = altitude},
                                fmt::format("pSurvey altitude_m = {:g}", altitude));
  return reason ? std::optional(Error{"object_height_max: " + *reason}) : std::nullopt;
}

/// A side that neither leaves `region` at its ends nor between two meetings with its border.
bool HoldsSide(const SimplePolygon& region, const PlaneEdge& side) {
  constexpr double kRounding = 0.02;  // of corners in text [m]
  std::vector<double> cuts{0.0, 1.0};
  const PlanePoint along = side.to_W - side.from_W;
  for (std::size_t i = 0; i < region.size(); ++i) {
    if (const auto at = Meeting(side, region.Edge(i))) {
      cuts.push_back((*at - side.from_W).dot(along) / along.squaredNorm());
    }
  }
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const double next = i + 1 < cuts.size() ? cuts[i + 1] : cuts[i];
    const PlanePoint between = side.from_W + 0.5 * (cuts[i] + next) * along;
    if (region.Depth(between) < -kRounding) return false;
  }
  return true;
}

/// What does not fit together: region and area, area and vehicle.
std::optional<Error> ProblemOfPlaces(const SurveyArea& area, const AreaSetting& setting) {
  const SurveyShape shape = *SurveyShape::Of(area);
  for (std::size_t i = 0; shape.region() && i < shape.outline().size(); ++i) {
    const PlaneEdge side = shape.outline().Edge(i);
    if (HoldsSide(*shape.region(), side)) continue;
    return Error{fmt::format(
        "`operating_region` does not hold the area: not all between x {:g}, y {:g} and x {:g}, y "
        "{:g}",
        side.from_W.y(), side.from_W.x(), side.to_W.y(), side.to_W.x())};
  }
  const bool is_in_zone =
      setting.vehicle_W && std::ranges::any_of(shape.zones(), [&](const SimplePolygon& zone) {
        return zone.Contains(*setting.vehicle_W);
      });
  if (is_in_zone) return Error{"the vehicle lies in a keep-out zone of the request"};
  const double off = shape.OutsideArea(setting.vehicle_W.value_or(PlanePoint::Zero()));
  if (off <= kFarthestSite) return std::nullopt;
  return Error{fmt::format("the area is {:.0f} km from {}; allowed: up to {:g} km", off / 1e3,
                           setting.vehicle_W ? "the vehicle" : "the mission's datum",
                           kFarthestSite / 1e3)};
}

}  // namespace

Expected<SurveyArea> RequestedArea(std::string_view text, const AreaSetting& setting) {
  const auto request = DecodeRecord<SurveyAreaRequest>(text);
  const auto places = request ? ParsePlaces(request->outline) : std::nullopt;
  if (!places) return Error{"it cannot be read; wanted: area={x,y:x,y:x,y} and what goes with it"};
  if (const auto problem = ProblemOfKeys(text)) return *problem;
  if (const auto polygon = SimplePolygon::Of(*places); !polygon) {
    return Error{"`area` " + polygon.error().text};
  }
  if (const auto problem = ProblemOfNumbers(*request, setting)) return *problem;
  SurveyArea area = AreaWithin(*places);
  area.margin = request->margin.value_or(setting.area.margin);
  area.object_height_max = request->object_height_max.value_or(setting.area.object_height_max);
  area.keep_out = request->keep_out;
  area.operating_region = request->operating_region;
  area.transit = request->transit;
  if (const auto problem = ProblemOf(area)) return Error{"the area " + *problem};
  if (const auto problem = ProblemOfPlaces(area, setting)) return *problem;
  return area;
}

}  // namespace limpet
