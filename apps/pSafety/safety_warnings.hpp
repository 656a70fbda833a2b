// SPDX-License-Identifier: MIT
// What pSafety warns of and reports.
#pragma once

#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningFamily kTripped = DeclareWarningFamily(
    "TRIPPED_<RULE>",
    {.severity = Severity::kAlarm,
     .raised_by = {"pSafety"},
     .meaning =
         "A safety rule asks for what its text says: warn, degrade, hold, return, surface or "
         "abort.",
     .action = "docs/safety.md says what each rule watches. If it was a false alarm, write "
               "SAFETY_RESET = true.",
     .clears = "As the table says, or with SAFETY_RESET."});

}  // namespace limpet::warnings

namespace limpet::events {

inline const EventId kSafetyAction =
    DeclareEvent("SAFETY", {.severity = Severity::kAlarm,
                            .reported_by = {"pSafety"},
                            .meaning = "Another safety action is in force; with its rule."});

inline const EventId kSafetyReset =
    DeclareEvent("SAFETY_RESET", {.severity = Severity::kNote,
                                  .reported_by = {"pSafety"},
                                  .meaning = "An operator has lifted what the rules asked for."});

}  // namespace limpet::events
