// SPDX-License-Identifier: MIT
// What pLog warns of.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kLogFailed = DeclareWarning(
    "LOG_FAILED",
    {.severity = Severity::kAlarm,
     .raised_by = {"pLog"},
     .meaning = "The log cannot be created or written: up to 4 MiB wait for the disk, "
                "then messages are dropped and counted.",
     .action = "Make room on the disk or mend its rights; it is tried again by itself.",
     .clears = "Once a log is open and can be written."});

inline const WarningId kLogDropped = DeclareWarning(
    "LOG_DROPPED", {.severity = Severity::kWarning,
                    .raised_by = {"pLog"},
                    .meaning = "The disk was too slow, full or failing: as many messages as the "
                               "text says are missing in the log, or may be.",
                    .action = "Log less (WildcardOmitPattern), or to a larger or faster disk.",
                    .clears = "With the next log, after LOGGER_RESTART."});

inline const WarningId kLogFolder = DeclareWarning(
    "LOG_FOLDER",
    {.severity = Severity::kWarning,
     .raised_by = {"pLog"},
     .meaning = "The folder for the log cannot be made: it is written to the working directory.",
     .action = "Mend Path or GlobalLogPath before the next dive; fetch this log from where it is.",
     .clears = "With the next log that lies where it should."});

inline const WarningFamily kSilent = DeclareWarningFamily(
    "SILENT_<VARIABLE>",
    {.severity = Severity::kWarning,
     .raised_by = {"pLog"},
     .meaning = "A variable that is to be logged with MONITOR has not been heard for 10 s.",
     .action = "See whether the app that writes it runs.",
     .clears = "With its next value."});

inline const WarningId kCopyRefused = DeclareWarning(
    "COPY_REFUSED",
    {.severity = Severity::kNote,
     .raised_by = {"pLog"},
     .meaning = "A COPY_FILE_REQUEST was refused: what it asks for is not of this mission or run.",
     .action = "Copy the file yourself; if nobody of yours asked, look who is on the network.",
     .clears = "After 60 s without another."});

}  // namespace limpet::warnings
