// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/bench/planner_study/study_run.hpp"

namespace limpet {

/// The track over area and region, early dark, late bright; former objects as stars.
void WriteTrackSvg(const std::string& file, const StudyCase& study, const StudyResult& result);

}  // namespace limpet
