// SPDX-License-Identifier: MIT
// What LimpetDB warns of.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kClockStepped = DeclareWarning(
    "CLOCK_STEPPED", {.severity = Severity::kWarning,
                      .raised_by = {"LimpetDB"},
                      .meaning = "The wall clock was set and differs from vehicle time by more "
                                 "than 0.5 s; vehicle time goes on as it was.",
                      .action = "Nothing for this mission; give wall-clock dates of this log with "
                                "the difference (WALL_CLOCK).",
                      .clears = "Once the two agree within 0.5 s."});

inline const WarningId kStrangers = DeclareWarning(
    "STRANGERS",
    {.severity = Severity::kWarning,
     .raised_by = {"LimpetDB"},
     .meaning = "Connections were closed that had not said who they are: too slow, or too many.",
     .action = "Look who is on the network.",
     .clears = "After 30 s (real time) without another."});

inline const WarningId kUnfinished = DeclareWarning(
    "UNFINISHED", {.severity = Severity::kWarning,
                   .raised_by = {"LimpetDB"},
                   .meaning = "Clients were cut amid a packet: too slow, or held_mib is used up.",
                   .action = "See which client went (the report) and how its network is.",
                   .clears = "After 30 s (real time) without another."});

inline const WarningId kStalled = DeclareWarning(
    "STALLED", {.severity = Severity::kWarning,
                .raised_by = {"LimpetDB"},
                .meaning = "Clients were cut that took no mail, or because held_mib is used up.",
                .action = "See which client went (the report): it hangs, or its network is down.",
                .clears = "After 30 s (real time) without another."});

inline const WarningFamily kSlow = DeclareWarningFamily(
    "SLOW_<CLIENT>", {.severity = Severity::kWarning,
                      .raised_by = {"LimpetDB"},
                      .meaning = "A client reads too slowly and has lost mail.",
                      .action = "See whether its machine or its network is overloaded.",
                      .clears = "After 30 s (real time) without more lost mail."});

inline const WarningId kNoRoom = DeclareWarning(
    "NO_ROOM",
    {.severity = Severity::kAlarm,
     .raised_by = {"LimpetDB"},
     .meaning = "Writes were refused: stored_mib is used up by the values that are kept.",
     .action = "Find in the report who writes so many or so large variables; raise stored_mib if "
               "it is meant so.",
     .clears = "After 30 s (real time) without another."});

}  // namespace limpet::warnings
