// SPDX-License-Identifier: MIT
// What a run says of itself in its report.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kSessionCut = DeclareWarning(
    "SESSION_CUT",
    {.severity = Severity::kAlarm,
     .raised_by = {"limpet"},
     .meaning =
         "The session did not end by itself: it was stopped at its time limit or by its user.",
     .action =
         "Read in the text where the vehicle was; what was found until then is in the report.",
     .clears = "It stands to the end of the run."});

}  // namespace limpet::warnings
