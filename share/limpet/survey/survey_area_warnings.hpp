// SPDX-License-Identifier: MIT
// Apps that hear SURVEY_AREA warn of one that they cannot use.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kAreaRefused = DeclareWarning(
    "AREA_REFUSED",
    {.severity = Severity::kAlarm,
     .raised_by = {"pHelm", "pMap"},
     .meaning = "SURVEY_AREA cannot be surveyed as it is: empty, not finite, or too large; the "
                "former one, if any, stays.",
     .action =
         "Correct the area (area_* of pSurvey, or who else writes SURVEY_AREA) and send it again.",
     .clears = "With the next area that can be surveyed."});

}  // namespace limpet::warnings
