// SPDX-License-Identifier: MIT
#include "limpet/planning/region_fences.hpp"

namespace limpet {

Fence HoldingFence(const SurveyShape& shape, Meters margin, Meters allowance) {
  if (shape.region()) {
    return {.polygon = *shape.region(), .distance = allowance.value(), .holds_in = true};
  }
  return {.polygon = shape.outline(),
          .distance = margin.value(),
          .holds_in = true,
          .reaches_over = true};
}

std::vector<Fence> ZoneFences(const SurveyShape& shape, Meters allowance) {
  std::vector<Fence> fences;
  for (const SimplePolygon& zone : shape.zones()) {
    fences.push_back({.polygon = zone, .distance = allowance.value()});
  }
  return fences;
}

}  // namespace limpet
