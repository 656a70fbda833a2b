// SPDX-License-Identifier: MIT
// Warnings of the host of behaviors itself.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningFamily kBehaviorUpdate = DeclareWarningFamily(
    "BHV_UPDATE_<BEHAVIOR>",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning =
         "An `updates` mail of a behavior cannot be applied: the behavior goes on as it was.",
     .action = "Send it again with what the text says corrected (`limpet describe` lists what a "
               "behavior takes).",
     .clears = "With the next update of the behavior that can be applied."});

}  // namespace limpet::warnings
