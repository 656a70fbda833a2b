// SPDX-License-Identifier: MIT
// What pHelm warns of and reports.
#pragma once

#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kObstacleRefused = DeclareWarning(
    "OBSTACLE_REFUSED",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning =
         "MAP_OBSTACLES holds an obstacle whose outline is no polygon: nothing keeps off it.",
     .action = "See who publishes MAP_OBSTACLES beside pMap.",
     .clears = "With the next MAP_OBSTACLES whose outlines are all polygons."});

inline const WarningId kBlocksPassedOver = DeclareWarning(
    "BLOCKS_PASSED_OVER",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning = "Blocks of a large area took several times the way that they should, or had no way "
                "left that was worth it, and were left with more than slivers unseen.",
     .action = "See in the report where that is, and why (murk, obstacles, a current); survey it "
               "again as an area of its own.",
     .clears = "Not in this session."});

inline const WarningId kBandAboveView = DeclareWarning(
    "BAND_ABOVE_VIEW",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning = "Objects may float so high that the camera cannot cover their band from "
                "survey_altitude_m.",
     .action =
         "Survey from higher up (survey_altitude_m), or lower object_height_max_m of pSurvey.",
     .clears = "With the next SURVEY_AREA whose band can be covered."});

inline const WarningId kMailSkewed = DeclareWarning(
    "MAIL_SKEWED",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning = "Mail was left out: its stamp is further from now than ok_skew allows.",
     .action = "Set the clock of who writes it, or give ok_skew more room (any: none is left out).",
     .clears = "With mail in time of each such variable."});

inline const WarningId kAppsAwaited = DeclareWarning(
    "APPS_AWAITED",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning = "Apps of hold_on_app are not connected yet: what behaviors ask for as the helm "
                "begins (OBM_ALERT_REQUEST) is not posted.",
     .action = "Start them, or take them out of hold_on_app.",
     .clears = "Once each of them was among the database's clients."});

inline const WarningId kRestartRefused = DeclareWarning(
    "RESTART_REFUSED",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning = "RESTART_HELM was not heeded, because it says neither type1 nor type2, or because "
                "the behavior files as they are now do not make a helm: the behaviors that there "
                "were go on.",
     .action = "Correct what the text names (`limpet check` says the same) and send it again.",
     .clears = "With a RESTART_HELM that is heeded."});

inline const WarningId kNoOption = DeclareWarning(
    "NO_OPTION",
    {.severity = Severity::kWarning,
     .raised_by = {"pHelm"},
     .meaning = "No option for the next view is left: all are vetoed, or none is offered; there is "
                "no new path.",
     .action =
         "See in `limpet why` who vetoes what; if it lasts, call the vehicle home with RETURN.",
     .clears = "With the next decision that finds an option."});

inline const WarningId kLedHelmDeaf = DeclareWarning(
    "LED_HELM_DEAF",
    {.severity = Severity::kAlarm,
     .raised_by = {"pHelm"},
     .meaning =
         "The helm that this one leads has refused an update, or said nothing of one for ten "
         "seconds (IVPHELM_UPDATE_RESULT): the vehicle may not go where it is told.",
     .action = "See that the other helm runs, that its behaviors have the lines `updates = ...` of "
               "`lead`, `lead_depth`, `lead_course` and `lead_speed`, and what BHV_WARNING says.",
     .clears = "Once each of its behaviors has taken an update again."});

inline const WarningId kObjectsGivenUp = DeclareWarning(
    "OBJECTS_GIVEN_UP",
    {.severity = Severity::kNote,
     .raised_by = {"pHelm"},
     .meaning = "Looks at the objects named told nothing so often that they get no more.",
     .action = "Nothing now; their status stays as uncertain as it is.",
     .clears = "Once a new belief makes a look at each of them worth its way again."});

inline const WarningId kObjectsOutOfReach = DeclareWarning(
    "OBJECTS_OUT_OF_REACH",
    {.severity = Severity::kNote,
     .raised_by = {"pHelm"},
     .meaning =
         "No pass inside the operating region at survey altitude would show the objects named.",
     .action = "Nothing now; to see them, widen margin_m of pSurvey in the next session.",
     .clears = "Once each of them can be seen from inside the region."});

}  // namespace limpet::warnings

namespace limpet::events {

inline const EventId kMode =
    DeclareEvent("HELM_MODE", {.severity = Severity::kNote,
                               .reported_by = {"pHelm"},
                               .meaning = "A mode of the behaviors has changed."});

inline const EventId kHelmBeganAnew = DeclareEvent(
    "HELM_BEGAN_ANEW",
    {.severity = Severity::kNote,
     .reported_by = {"pHelm"},
     .meaning = "RESTART_HELM: all behaviors have been made anew from the files as they are now."});

inline const EventId kPath = DeclareEvent(
    "PATH_CHOSEN",
    {.severity = Severity::kNote,
     .reported_by = {"pHelm"},
     .meaning = "The helm has decided where to go next; with its length and why it decided now."});

inline const EventId kFruitlessLook = DeclareEvent(
    "FRUITLESS_LOOK",
    {.severity = Severity::kNote,
     .reported_by = {"pHelm"},
     .meaning = "A look at an object has told nothing about it; with how many did so in a row."});

}  // namespace limpet::events
