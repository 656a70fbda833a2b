// SPDX-License-Identifier: MIT
// What pPilot warns of.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningFamily kRefusedInput = DeclareWarningFamily(
    "REFUSED_<VARIABLE>",
    {.severity = Severity::kWarning,
     .raised_by = {"pPilot"},
     .meaning =
         "A wish or NAV_STATE is not finite or not of this world, or SAFETY_ACTION is no action; "
         "it counts as not heard.",
     .action = "See who writes the variable.",
     .clears = "With its next plausible value."});

inline const WarningId kDesiredStale = DeclareWarning(
    "DESIRED_STALE",
    {.severity = Severity::kAlarm,
     .raised_by = {"pPilot"},
     .meaning = "A wish of the helm (DESIRED_HEADING, _SPEED, _DEPTH) is older than stale_after_s "
                "and no all-stop says why: thrusters are stopped, the vehicle floats up.",
     .action = "See whether pHelm runs and what it reports; the vehicle comes up by itself.",
     .clears = "Once all three are fresh, or the helm says that it has stopped all."});

inline const WarningId kNavStale = DeclareWarning(
    "NAV_STALE",
    {.severity = Severity::kAlarm,
     .raised_by = {"pPilot"},
     .meaning = "NAV_STATE is not valid or older than stale_after_s: thrusters are stopped, the "
                "vehicle floats up.",
     .action = "See whether pNav runs and what it warns of; the vehicle comes up by itself.",
     .clears = "Once NAV_STATE is valid and fresh, or nothing is to be flown."});

inline const WarningId kCommandNotFinite = DeclareWarning(
    "COMMAND_NOT_FINITE",
    {.severity = Severity::kAlarm,
     .raised_by = {"pPilot"},
     .meaning = "The control laws gave no number: thrusters are stopped and the laws start anew.",
     .action = "Send the log to the developers; the mission goes on if it clears.",
     .clears = "With the next command that is a number."});

}  // namespace limpet::warnings
