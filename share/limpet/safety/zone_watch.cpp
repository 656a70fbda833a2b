// SPDX-License-Identifier: MIT
#include "limpet/safety/zone_watch.hpp"

#include <algorithm>

#include "limpet/survey/inscribed_circle.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {

ZoneWatch::ZoneWatch(const SurveyArea& area) {
  const Expected<SurveyShape> shape = SurveyShape::Of(area);
  for (const SimplePolygon& zone : shape->zones()) {
    zones_.push_back({.outline = zone, .radius = InscribedRadius(zone)});
  }
}

std::optional<double> ZoneWatch::ShareAt(const PlanePoint& at) const {
  std::optional<double> greatest;
  for (const Zone& zone : zones_) {
    greatest = std::max(greatest.value_or(0.0), zone.outline.Depth(at) / zone.radius);
  }
  return greatest;
}

}  // namespace limpet
