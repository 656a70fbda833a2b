// SPDX-License-Identifier: MIT
// What uSimCamera warns of.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kNoFalseBoxes = DeclareWarning(
    "NO_FALSE_BOXES",
    {.severity = Severity::kWarning,
     .raised_by = {"uSimCamera"},
     .meaning =
         "The scenario asks for false boxes (fault `false_boxes`), which a camera of rendered "
         "pictures does not make: whoever detects in them finds what it finds.",
     .action = "Set camera = boxes in the block of uSimCamera, or take the fault out.",
     .clears = "It stands to the end of the run."});

}  // namespace limpet::warnings
