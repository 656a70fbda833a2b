// SPDX-License-Identifier: MIT
// Warnings that every app can raise, and those that several raise for one reason.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningFamily kBadMail = DeclareWarningFamily(
    "BAD_MAIL_<VARIABLE>",
    {.severity = Severity::kWarning,
     .raised_by = {},
     .meaning = "A value of a variable that the app hears does not decode and was left out.",
     .action = "See who sent it and compare its form with docs/variables.md.",
     .clears = "With the next value that decodes."});

inline const WarningFamily kStampFromFuture = DeclareWarningFamily(
    "STAMP_FROM_FUTURE_<VARIABLE>",
    {.severity = Severity::kWarning,
     .raised_by = {},
     .meaning = "Values are stamped more than 0.5 s ahead of vehicle time, or with no time at all, "
                "and are refused.",
     .action = "Set the clock of the sender that the text names.",
     .clears = "Once the variable's stamps have been right for 2 s."});

inline const WarningId kClockDiffers = DeclareWarning(
    "CLOCK_DIFFERS",
    {.severity = Severity::kWarning,
     .raised_by = {},
     .meaning = "The database's clock has run more than 0.5 s away from vehicle time, which the "
                "app keeps by itself.",
     .action = "Find out who sets the clock of the database's machine; the mission goes on.",
     .clears = "Once the two agree within 0.5 s."});

inline const WarningId kJournalLost = DeclareWarning(
    "JOURNAL_LOST",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap", "pNav", "pSession"},
     .meaning = "What the app has heard can no longer be written: if it fails, the one that is "
                "started in its place knows nothing of this life.",
     .action = "Make room on the disk or mend it before the next dive.",
     .clears = "It stands to the end of the run."});

inline const WarningId kBadCommand = DeclareWarning(
    "BAD_COMMAND",
    {.severity = Severity::kWarning,
     .raised_by = {"pLog", "pShare"},
     .meaning = "A command was not obeyed: it has no meaning here, or the app's block forbids it.",
     .action = "Send it again as the text says.",
     .clears = "With the next command that is obeyed."});

}  // namespace limpet::warnings
