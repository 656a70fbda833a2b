// SPDX-License-Identifier: MIT
// What pSession warns of and reports.
#pragma once

#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kFormerSession = DeclareWarning(
    "FORMER_SESSION",
    {.severity = Severity::kWarning,
     .raised_by = {"pSession"},
     .meaning = "The run folder holds a former session: nothing is saved until this one is "
                "deployed and has seen something; the former is set aside then.",
     .action = "If the former one is to be gone on with or to stay where it is, end this run and "
               "give another --run_folder.",
     .clears = "Once the former session has been set aside."});

inline const WarningId kFormerSessionCut = DeclareWarning(
    "FORMER_SESSION_CUT",
    {.severity = Severity::kWarning,
     .raised_by = {"pSession"},
     .meaning =
         "The session that this one compares with was cut short, or is still under way: what "
         "it saw after it was last saved is not known here.",
     .action = "Before a dive: end this run, and bring it in by `limpet session recover`.",
     .clears = "It stands to the end of the run."});

inline const WarningId kFormerSessionAside = DeclareWarning(
    "FORMER_SESSION_ASIDE", {.severity = Severity::kNote,
                             .raised_by = {"pSession"},
                             .meaning = "The former session of the run folder has been set aside, "
                                        "to the folder that the text names.",
                             .action = "Nothing; you find it there.",
                             .clears = "It stands to the end of the run."});

inline const WarningId kSessionNotResumed = DeclareWarning(
    "SESSION_NOT_RESUMED",
    {.severity = Severity::kWarning,
     .raised_by = {"pSession"},
     .meaning =
         "Started again, the app cannot read what its former life saved; it begins a new session.",
     .action = "Keep the run folder: what was saved is set aside, not lost.",
     .clears = "It stands to the end of the run."});

inline const WarningId kSessionNotSaved = DeclareWarning(
    "SESSION_NOT_SAVED",
    {.severity = Severity::kAlarm,
     .raised_by = {"pSession"},
     .meaning = "The session cannot be saved: what is found from now on is lost with this process.",
     .action = "Make room on the disk or mend its rights, then write SESSION_SAVE.",
     .clears = "Once a generation has been saved."});

inline const WarningId kMapSilent =
    DeclareWarning("MAP_SILENT", {.severity = Severity::kWarning,
                                  .raised_by = {"pSession"},
                                  .meaning = "pMap has not answered with MAP_TILES in time: the "
                                             "session is saved with the last map known.",
                                  .action = "See whether pMap runs and keeps up.",
                                  .clears = "With the next MAP_TILES."});

}  // namespace limpet::warnings

namespace limpet::events {

inline const EventId kSessionResumed = DeclareEvent(
    "SESSION_RESUMED",
    {.severity = Severity::kNote,
     .reported_by = {"pSession"},
     .meaning =
         "Started again, the app goes on from the generation that its former life saved last."});

inline const EventId kSessionSaved = DeclareEvent(
    "SESSION_SAVED",
    {.severity = Severity::kNote,
     .reported_by = {"pSession"},
     .meaning = "A generation of the session has been saved; with its number and cause."});

inline const EventId kExportsLeftOut = DeclareEvent(
    "EXPORTS_LEFT_OUT",
    {.severity = Severity::kNote,
     .reported_by = {"pSession"},
     .meaning = "The map is too large to be written for other programs on board, or what was saved "
                "of it cannot be read back: the session is saved without `export/`."});

}  // namespace limpet::events
