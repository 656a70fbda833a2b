// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/expected.hpp"
#include "limpet/survey/survey_params.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// What is wrong with the area of a mission: the parameter of pSurvey, and why.
struct AreaProblem {
  std::string key;
  std::string text;
  bool is_unreadable = false;  ///< not said, or no list of points; else it reads well and cannot be
};

/// The area that pSurvey's block describes: four bounds, or `area`, and what goes with it.
[[nodiscard]] Expected<SurveyArea, AreaProblem> AreaOf(const SurveyParams& params);

}  // namespace limpet
