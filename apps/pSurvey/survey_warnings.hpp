// SPDX-License-Identifier: MIT
// What pSurvey warns of and reports.
#pragma once

#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kStateNotKept = DeclareWarning(
    "STATE_NOT_KEPT", {.severity = Severity::kWarning,
                       .raised_by = {"pSurvey"},
                       .meaning = "The phase of the mission cannot be written to the run folder: a "
                                  "pSurvey that is started again would not know it.",
                       .action = "Make room on the disk or mend its rights; it is tried again "
                                 "each 10 s.",
                       .clears = "Once it has been written."});

inline const WarningId kTransitStalled = DeclareWarning(
    "TRANSIT_STALLED",
    {.severity = Severity::kWarning,
     .raised_by = {"pSurvey"},
     .meaning = "On the way out the area has not come nearer for stall_s: the vehicle goes home.",
     .action =
         "See what held it up: current, a region that does not let it in, a helm without options.",
     .clears = "It stands to the end of the run."});

inline const WarningId kCoverageStalled = DeclareWarning(
    "COVERAGE_STALLED",
    {.severity = Severity::kWarning,
     .raised_by = {"pSurvey"},
     .meaning =
         "Coverage has not grown for stall_s: the vehicle goes home short of coverage_target.",
     .action = "See in the report what is left and why; survey the rest in another session.",
     .clears = "It stands to the end of the run."});

inline const WarningId kOutOfSight = DeclareWarning(
    "OUT_OF_SIGHT",
    {.severity = Severity::kWarning,
     .raised_by = {"pSurvey"},
     .meaning = "The water hides what the survey seeks from survey altitude (WATER_STATE), and "
                "nothing new has come into sight for stall_s: the vehicle goes home.",
     .action = "Survey from lower, or another day; what was not in sight is not inspected.",
     .clears = "It stands to the end of the run."});

inline const WarningId kNavLost = DeclareWarning(
    "NAV_LOST",
    {.severity = Severity::kAlarm,
     .raised_by = {"pSurvey"},
     .meaning = "No NAV_STATE has been heard within lost_s: the mission has ended here.",
     .action = "Recover the vehicle where it comes up; see whether pNav ran.",
     .clears = "It stands to the end of the run."});

inline const WarningId kGaveUp = DeclareWarning(
    "GAVE_UP",
    {.severity = Severity::kAlarm,
     .raised_by = {"pSurvey"},
     .meaning =
         "Diving, returning or ascending took longer than give_up_s: the mission has ended here.",
     .action = "Recover the vehicle where it is; see whether its thrusters and its trim are sound.",
     .clears = "It stands to the end of the run."});

inline const WarningId kHelmInactive = DeclareWarning(
    "HELM_INACTIVE", {.severity = Severity::kAlarm,
                      .raised_by = {"pSurvey"},
                      .meaning = "A mission is under way and for 10 s the helm has been silent, "
                                 "parked, or has stopped all.",
                      .action = "See whether pHelm runs, MOOS_MANUAL_OVERRIDE and IVPHELM_ALLSTOP.",
                      .clears = "Once the helm drives, or the mission is over."});

}  // namespace limpet::warnings

namespace limpet::events {

inline const EventId kPhase = DeclareEvent("PHASE", {.severity = Severity::kNote,
                                                     .reported_by = {"pSurvey"},
                                                     .meaning = "The mission enters a phase."});

inline const EventId kGoingHome = DeclareEvent(
    "GOING_HOME", {.severity = Severity::kNote,
                   .reported_by = {"pSurvey"},
                   .meaning = "The survey is over and the vehicle goes home; with the reason."});

inline const EventId kSurfacing =
    DeclareEvent("SURFACING_FOR_SAFETY",
                 {.severity = Severity::kAlarm,
                  .reported_by = {"pSurvey"},
                  .meaning = "Safety asks for the surface: the mission ends there, as aborted."});

inline const EventId kReturnRequest = DeclareEvent(
    "RETURN_REQUEST",
    {.severity = Severity::kNote,
     .reported_by = {"pSurvey"},
     .meaning = "An operator, or safety, asked for the return; with what comes of it."});

inline const EventId kAreaRequest = DeclareEvent(
    "AREA_REQUEST", {.severity = Severity::kNote,
                     .reported_by = {"pSurvey"},
                     .meaning = "An operator asked for another area; with what comes of it."});

inline const EventId kAreaReached =
    DeclareEvent("AREA_REACHED", {.severity = Severity::kNote,
                                  .reported_by = {"pSurvey"},
                                  .meaning = "The vehicle has come into the area to survey."});

inline const EventId kMissionEnd =
    DeclareEvent("MISSION_ENDED", {.severity = Severity::kNote,
                                   .reported_by = {"pSurvey"},
                                   .meaning = "The mission has ended; with how."});

}  // namespace limpet::events
