// SPDX-License-Identifier: MIT
#include "limpet/scoring/lower_bound.hpp"

#include <algorithm>

#include "limpet/survey/survey_shape.hpp"

namespace limpet {

LowerBound LowerBoundOf(const SurveyArea& area, const ReportSettings& settings) {
  const auto shape = SurveyShape::Of(area);
  // A log may hold anything: an area that is none is its box, as it is scored.
  const double box = (area.north_max - area.north_min) * (area.east_max - area.east_min);
  const double height = settings.altitude_m - settings.object_height_max_m;
  return {.area_m2 = shape ? shape->WantedArea() : std::max(box, 0.0),
          .swath_m = 2.0 * std::max(height, 0.0) * settings.camera_geometry.half_across()};
}

}  // namespace limpet
