// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
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

/// What the rest of a mission says that an area may need.
struct SiteGlobals {
  std::filesystem::path folder;     ///< of the mission: where files are looked for
  std::string latitude, longitude;  ///< LatOrigin and LongOrigin, as they are written
};

/// The area that pSurvey's block describes: four bounds, `area` or `area_geojson`, and what goes
/// with it. Reads that file.
[[nodiscard]] Expected<SurveyArea, AreaProblem> AreaOf(const SurveyParams& params,
                                                       const SiteGlobals& site);

}  // namespace limpet
