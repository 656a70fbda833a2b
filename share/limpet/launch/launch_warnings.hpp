// SPDX-License-Identifier: MIT
// What pLaunch warns of and reports.
#pragma once

#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningFamily kDown = DeclareWarningFamily(
    "DOWN_<PROCESS>", {.severity = Severity::kAlarm,
                       .raised_by = {"pLaunch"},
                       .meaning = "A process of the mission does not run: its program is missing, "
                                  "it waits to be started again, or it is given up.",
                       .action = "Read in the text how it ended and where it wrote; mend that. "
                                 "What the mission cannot do without ends it at the surface.",
                       .clears = "Once the process runs."});

inline const WarningId kNotUnderWay = DeclareWarning(
    "NOT_UNDER_WAY",
    {.severity = Severity::kAlarm,
     .raised_by = {"pLaunch"},
     .meaning = "All is up and DEPLOY was written, but the mission has not begun within 10 s.",
     .action = "The text says what is missing: DEPLOY, the phase, or a helm that does not drive.",
     .clears = "Once the mission is under way."});

inline const WarningId kMissionLost = DeclareWarning(
    "MISSION_LOST", {.severity = Severity::kAlarm,
                     .raised_by = {"pLaunch"},
                     .meaning = "An app is given up that the mission cannot do without: thrust is "
                                "off, the vehicle floats up, and the mission is aborted there.",
                     .action = "Recover the vehicle; the text names the app.",
                     .clears = "It stands to the end of the run."});

}  // namespace limpet::warnings

namespace limpet::events {

inline const EventId kProcess =
    DeclareEvent("PROCESS", {.severity = Severity::kWarning,
                             .reported_by = {"pLaunch"},
                             .meaning = "A process ended by itself, hung, was killed, or could not "
                                        "be started; with what becomes of it."});

inline const EventId kDeployment = DeclareEvent(
    "DEPLOYMENT", {.severity = Severity::kWarning,
                   .reported_by = {"pLaunch"},
                   .meaning = "The mission is late to get under way, or is under way after all."});

inline const EventId kSurfacing =
    DeclareEvent("SURFACING", {.severity = Severity::kAlarm,
                               .reported_by = {"pLaunch"},
                               .meaning = "The mission cannot go on: the vehicle is brought up, or "
                                          "is up and the mission has ended."});

inline const EventId kThrustNotZeroed = DeclareEvent(
    "THRUST_NOT_ZEROED", {.severity = Severity::kWarning,
                          .reported_by = {"pLaunch"},
                          .meaning = "At the end the database did not take the last command, zero "
                                     "thrust; the driver stops by itself."});

}  // namespace limpet::events
