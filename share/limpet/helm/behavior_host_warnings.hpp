// SPDX-License-Identifier: MIT
// Warnings of the host of behaviors itself.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningFamily kBehaviorUpdate = DeclareWarningFamily(
    "BHV_UPDATE_<BEHAVIOR>",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning = "Parts of an `updates` mail of a behavior cannot be applied: it goes on without "
                "them; or a behavior that a mail asks for cannot be made.",
     .action = "Send it again with what the text says corrected (`limpet describe` lists what a "
               "behavior takes).",
     .clears = "With the next update of the behavior that can be applied."});

inline const WarningFamily kBehaviorKeys = DeclareWarningFamily(
    "BHV_KEYS_<BEHAVIOR>",
    {.severity = Severity::kNote,
     .raised_by = {"pHelm"},
     .meaning = "The block of a behavior has keys of existing missions that have no effect here.",
     .action = "See in docs/parameters.md whether the mission needs them; else remove them.",
     .clears = "Once the behavior is gone."});

inline const WarningFamily kBehaviorValues = DeclareWarningFamily(
    "BHV_VALUES_<BEHAVIOR>",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning =
         "The block of a behavior has values that are not allowed: the nearest ones that are "
         "count, as in MOOS-IvP.",
     .action = "Write what is meant; the text has what was taken.",
     .clears = "Once the behavior is gone."});

}  // namespace limpet::warnings
