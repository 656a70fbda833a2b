// SPDX-License-Identifier: MIT
// Warnings of the arbitration.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningFamily kBehaviorFailed = DeclareWarningFamily(
    "BHV_FAILED_<BEHAVIOR>",
    {.severity = Severity::kAlarm,
     .raised_by = {"pHelm"},
     .meaning = "A behavior has thrown an exception, or bid a number that is none: its bid, on the "
                "motion or on where next, is not heard, the others are. BHV_ERROR says the same. "
                "So it is for one that cannot be started; it is tried again each time. What one "
                "throws elsewhere (idle, at its end, in a flag's macro) costs it that alone.",
     .action = "Bring the vehicle home if it cannot do without that behavior; then look at its "
               "parameters and code.",
     .clears = "With its next bid that can be heard, or when it runs no more."});

}  // namespace limpet::warnings
