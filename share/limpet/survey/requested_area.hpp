// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/survey/simple_polygon.hpp"
#include "limpet/survey/survey_params.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// What a request is judged by.
struct AreaSetting {
  const SurveyArea& area;                 ///< surveyed now
  const SurveyParams& params;             ///< of the mission
  std::optional<PlanePoint> vehicle_W{};  ///< where it is, if anybody knows
  Meters object_radius{0.0};              ///< as far as the mission says it
};

/// The area that a SURVEY_AREA_REQUEST, less its hash, asks for. The error says why it cannot be:
/// it cannot be read, says what nothing knows, or cannot be surveyed.
[[nodiscard]] Expected<SurveyArea> RequestedArea(std::string_view text, const AreaSetting& setting);

}  // namespace limpet
