// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "limpet/survey/geo_area.hpp"
#include "limpet/survey/survey_shape.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto area = limpet::ParseGeoArea(text)) {
    const auto places =
        limpet::PlacesOnGrid(area->outline, {.latitude_deg = 43.7, .longitude_deg = 10.3});
    // What is near and a polygon can be surveyed or is refused, and never worse.
    if (places && limpet::SimplePolygon::Of(*places)) {
      static_cast<void>(limpet::SurveyShape::Of(limpet::AreaWithin(*places)));
    }
  }
  const auto area = limpet::DecodeRecord<limpet::SurveyArea>(text);
  if (area && !limpet::DecodeRecord<limpet::SurveyArea>(limpet::EncodeRecord(*area))) {
    std::abort();
  }
  return 0;
}
