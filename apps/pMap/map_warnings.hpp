// SPDX-License-Identifier: MIT
// What pMap warns of.
#pragma once

#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kFrameOutOfOrder =
    DeclareWarning("FRAME_OUT_OF_ORDER",
                   {.severity = Severity::kNote,
                    .raised_by = {"pMap"},
                    .meaning = "A frame came after a later one and was left out.",
                    .action = "Nothing if it is rare; else see whether the machine keeps up.",
                    .clears = "With the next frame in order."});

inline const WarningId kViewTooHigh =
    DeclareWarning("VIEW_TOO_HIGH",
                   {.severity = Severity::kWarning,
                    .raised_by = {"pMap"},
                    .meaning = "While surveying, frames are taken from higher above the seabed "
                               "than highest_view_m, not on the way to a fix at the surface "
                               "(SURFACE_FIX) or back: they show nothing and count for nothing.",
                    .action = "See why the vehicle flies high (NAV_ALTITUDE, ALTITUDE_LOST); or "
                              "raise highest_view_m where the water is clear.",
                    .clears = "With the next frame from low enough, or out of the survey phase."});

inline const WarningId kViewWithoutAltitude = DeclareWarning(
    "VIEW_WITHOUT_ALTITUDE",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap"},
     .meaning =
         "While surveying, frames are left out: no altitude is known within altitude_lasts_s.",
     .action = "See DVL_NO_LOCK of pNav.",
     .clears = "With the next frame of known altitude, or out of the survey phase."});

inline const WarningId kWaterMurky = DeclareWarning(
    "WATER_MURKY",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap"},
     .meaning = "While surveying, an object on the seabed would more likely than not be out of "
                "sight from the altitude flown: so says how far objects were and were not seen.",
     .action = "Fly lower, or another day; what was not seen is not proven absent (docs/water.md).",
     .clears = "Once one would still be in sight from a fifth higher, or out of the "
               "survey phase."});

inline const WarningId kBeamsLeftOut = DeclareWarning(
    "BEAMS_LEFT_OUT",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap"},
     .meaning = "A quarter or more of the latest 200 DVL beams end where neither seabed nor "
                "objects can be.",
     .action = "Check the lever arm and the mounting of the DVL (pNav), and the depth sensor.",
     .clears = "After 200 beams of which fewer do."});

inline const WarningId kFormerParameters = DeclareWarning(
    "FORMER_PARAMETERS",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap"},
     .meaning = "Parameters that the former session was saved with are out of range: where it "
                "looked is not used, and nothing will be called new.",
     .action = "Judge new objects by hand; compare the versions of Limpet of both sessions.",
     .clears = "With a former session whose parameters can be used."});

inline const WarningId kTentativeObjectsLeftOut = DeclareWarning(
    "TENTATIVE_OBJECTS_LEFT_OUT",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap"},
     .meaning = "Boxes hint at more objects than can be kept in mind: some places are not looked "
                "at again.",
     .action = "See in the frames whether the detector takes something else for objects.",
     .clears = "Once all such places are kept again."});

inline const WarningId kLandmarksDoubted = DeclareWarning(
    "LANDMARKS_DOUBTED",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap"},
     .meaning = "pNav has seen objects at least ten times that the map takes for none: most of its "
                "looks there show no box that such an object would have.",
     .action = "See in the frames what is there: it may be larger or smaller than pNav takes it to "
               "be (radius_m in NAV_LANDMARKS), or something that shows now and then only.",
     .clears = "Once the map has each of them for an object, or pNav drops them."});

inline const WarningId kFormerAllGone = DeclareWarning(
    "FORMER_ALL_GONE",
    {.severity = Severity::kWarning,
     .raised_by = {"pMap"},
     .meaning = "Three or more objects of the former session are removed and none was found again: "
                "either all are gone, or the two sessions' frames lie farther apart than their "
                "fixes and session_offset_sigma_m say, and it looked beside them.",
     .action = "Compare both sessions' fixes (GPS_REFUSED of pNav) and datums; see whether the new "
               "objects lie to each other as the removed ones did.",
     .clears = "Once one of them is found, or its status is open again."});

}  // namespace limpet::warnings

namespace limpet::events {

inline const EventId kObstacleFound = DeclareEvent(
    "OBSTACLE_FOUND", {.severity = Severity::kNote,
                       .reported_by = {"pMap"},
                       .meaning = "Sonar or DVL found something that stands in the vehicle's way; "
                                  "paths keep off it from now on."});

}  // namespace limpet::events
