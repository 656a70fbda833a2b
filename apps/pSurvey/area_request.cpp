// SPDX-License-Identifier: MIT
#include "apps/pSurvey/area_request.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/record.hpp"
#include "limpet/session/checksum.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/topics/area_request.hpp"

namespace limpet {
namespace {

constexpr std::string_view kHash = "hash=";

/// A request as its hash, if it has one, and what that is of.
struct SealedText {
  std::optional<std::string_view> hash;
  std::string_view body;
};
SealedText SealedTextOf(std::string_view text) {
  text = Trim(text);
  if (!text.starts_with(kHash)) return {.hash = std::nullopt, .body = text};
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::size_t behind = std::min(comma + 1, text.size());
  return {.hash = text.substr(kHash.size(), comma - kHash.size()), .body = text.substr(behind)};
}

}  // namespace

std::string HashOfRequest(std::string_view text) { return ChecksumOf(SealedTextOf(text).body); }

Expected<SurveyArea> AreaRequested(std::string_view text, const SurveyArea& now) {
  const SealedText sealed = SealedTextOf(text);
  if (sealed.hash && *sealed.hash != ChecksumOf(sealed.body)) {
    return Error{"it came damaged: its hash is of another text"};
  }
  const auto request = DecodeRecord<SurveyAreaRequest>(sealed.body);
  const auto places = request ? ParsePlaces(request->outline) : std::nullopt;
  if (!places) return Error{"it cannot be read; wanted: area={x,y:x,y:x,y} and what goes with it"};
  if (const auto polygon = SimplePolygon::Of(*places); !polygon) {
    return Error{"`area` " + polygon.error().text};
  }
  SurveyArea area = AreaWithin(*places);
  area.margin = request->margin.value_or(now.margin);
  area.object_height_max = request->object_height_max.value_or(now.object_height_max);
  area.keep_out = request->keep_out;
  area.operating_region = request->operating_region;
  area.transit = request->transit;
  if (const auto problem = ProblemOf(area)) return Error{"the area " + *problem};
  return area;
}

}  // namespace limpet
