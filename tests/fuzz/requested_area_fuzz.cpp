// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "limpet/survey/requested_area.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "tests/fuzz/time_bound.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const limpet::TimeBound bound(size);
  const limpet::SurveyArea now{.north_max = 5.0, .east_max = 5.0};
  const limpet::SurveyParams params;
  const auto area = limpet::RequestedArea(
      text, {.area = now, .params = params, .vehicle_W = limpet::PlanePoint(1.0, 2.0)});
  // What is accepted goes to every app, each of which takes its shape for granted.
  if (area && !limpet::SurveyShape::Of(*area)) std::abort();
  return 0;
}
