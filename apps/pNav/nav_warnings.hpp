// SPDX-License-Identifier: MIT
// What pNav warns of.
#pragma once

#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kImuStale = DeclareWarning(
    "IMU_STALE",
    {.severity = Severity::kAlarm,
     .raised_by = {"pNav"},
     .meaning = "No IMU_DATA has been heard within stale_after_s: there is no attitude.",
     .action = "Bring the vehicle up (RETURN, or MOOS_MANUAL_OVERRIDE if it does not obey); see to "
               "the IMU and its driver.",
     .clears = "With the next IMU_DATA."});

inline const WarningId kFogStale = DeclareWarning(
    "FOG_STALE",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "No FOG_YAW_RATE has been heard within stale_after_s, though it was before: the "
                "yaw rate of the IMU serves, and the heading drifts faster.",
     .action = "See to the FOG and its driver.",
     .clears = "With the next FOG_YAW_RATE."});

inline const WarningId kDvlStale = DeclareWarning(
    "DVL_STALE", {.severity = Severity::kWarning,
                  .raised_by = {"pNav"},
                  .meaning = "No DVL_DATA has been heard within stale_after_s: velocity is "
                             "guessed, and the position drifts.",
                  .action = "See to the DVL and its driver; if it lasts, call the vehicle home.",
                  .clears = "With the next DVL_DATA."});

inline const WarningId kDvlNoLock = DeclareWarning(
    "DVL_NO_LOCK",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "The DVL has had no bottom lock within stale_after_s: velocity is guessed, "
                "altitude is unknown.",
     .action = "Nothing at the surface or over deep water; else see how high the vehicle flies.",
     .clears = "With the next ping that has bottom lock."});

inline const WarningId kDepthStale = DeclareWarning(
    "DEPTH_STALE",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning =
         "No DEPTH_SENSOR has been heard within stale_after_s: depth is integrated, and drifts.",
     .action = "See to the depth sensor and its driver; if it lasts, call the vehicle home.",
     .clears = "With the next DEPTH_SENSOR."});

inline const WarningId kSonarStale = DeclareWarning(
    "SONAR_STALE",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "No OBSTACLE_SONAR has been heard within stale_after_s, though it was before, or "
                "none but the same echoes again: what stands in the way shows to the DVL's beams "
                "only.",
     .action =
         "Where there may be obstacles call the vehicle home; see to the sonar and its driver.",
     .clears = "With the next OBSTACLE_SONAR."});

inline const WarningId kGpsRefused = DeclareWarning(
    "GPS_REFUSED",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "Fixes lie metres from where dead reckoning and the other fixes have the vehicle: "
                "reflections, or dead reckoning is wrong. They are not used unless they stay.",
     .action = "See that the antenna is out of the water and off walls and hulls; wait for good "
               "fixes before the dive.",
     .clears = "10 s after the last such fix."});

inline const WarningId kGpsWorse = DeclareWarning(
    "GPS_WORSE",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "Fixes wander more than twice as far as sigma_m of the vehicle's file, which they "
                "state, allows: they are believed as far as they show, and the whole session may "
                "lie metres off, as its sigmas say.",
     .action = "See to the antenna and to what reflects around it; correct sigma_m of the "
               "vehicle's file if the receiver is like that.",
     .clears = "Once fixes, of other stays too, have shown otherwise."});

inline const WarningId kDepthNotZeroed = DeclareWarning(
    "DEPTH_NOT_ZEROED",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "Ten fixes in a row have come while the depth sensor read a depth that no antenna "
                "is out of the water at: it was not zeroed, or tells the absolute pressure (10 m "
                "at the surface). It is believed all the same: all depths are off by that.",
     .action = "Zero the depth sensor at the surface before the dive; see antenna_m of the "
               "vehicle's file.",
     .clears = "With a fix at a depth of the surface."});

inline const WarningFamily kAidingSilent = DeclareWarningFamily(
    "AIDING_SILENT_<SOURCE>",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "A further sensor that pNav's block names (`sources`) has said nothing for a "
                "minute, or ever: navigation goes on without it.",
     .action = "See to its driver, and whether it writes the variable that docs/variables.md has.",
     .clears = "With the next that it says."});

inline const WarningFamily kAidingRefused = DeclareWarningFamily(
    "AIDING_REFUSED_<SOURCE>",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "What a further sensor says has been far off what all others say, five times in a "
                "row: it is not used. What is less than 25 sigmas off is believed at the tenth.",
     .action = "See to its place, units and sigma in pNav's block; surface for fixes if it may be "
               "navigation that is wrong.",
     .clears = "With the next that is believed."});

inline const WarningId kCompassDeviates = DeclareWarning(
    "COMPASS_DEVIATES",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "The magnetic heading is off, or swings as the vehicle turns, by far more than "
                "heading_sigma_deg of the vehicle's file: what is known of that is taken out, and "
                "the heading of all the map is believed less.",
     .action = "Calibrate the compass, away from iron; see what was mounted beside it.",
     .clears = "Once what is seen of it is within that again."});

inline const WarningId kFormerElsewhere = DeclareWarning(
    "FORMER_ELSEWHERE",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "The former session's objects were recognised, but lie metres or degrees away from "
                "where its fixes and compass have them: of that session only the shape is used.",
     .action = "Compare datum, GPS and compass of both sessions: one of them is wrong.",
     .clears = "Once its objects are found where they were said to be."});

inline const WarningId kObjectsUnplaced = DeclareWarning(
    "OBJECTS_UNPLACED",
    {.severity = Severity::kWarning,
     .raised_by = {"pNav"},
     .meaning = "Boxes showed something a dozen times and more, surely, and agreed in no place: no "
                "landmark stands there, so it is missing from map and verdicts.",
     .action = "See in the frames what is there: an object so large and near that no image holds "
               "it, one of quite another size than object_radius_m, or one that moves. Fly higher "
               "there, or say its size.",
     .clears = "Once a landmark stands within 3 m of each."});

inline const WarningFamily kSensorsDisagree = DeclareWarningFamily(
    "SENSORS_DISAGREE_<MOTION>",
    {.severity = Severity::kAlarm,
     .raised_by = {"pNav"},
     .meaning =
         "Two sensors say quite another thing of the same motion, stretch after stretch: the "
         "compass turns against the gyro or by another share (TURN), depth goes otherwise than "
         "the DVL sinks (DIVE), fixes go otherwise than the DVL by the heading (WAY), boxes "
         "move otherwise through the images than the vehicle goes (SEE), the DVL goes "
         "otherwise than the thrusters push (DRIVE). A sign, an axis, a mounting or a unit is "
         "wrong, in a driver or in the vehicle's file; both are believed all the same, and "
         "places are wrong.",
     .action = "Do not dive, or bring the vehicle up. See which of the two is right by hand: turn "
               "the vehicle to starboard, push it ahead, lower it.",
     .clears = "Once they agree in most of five to nine stretches with enough motion."});

inline const WarningId kNavInvalid = DeclareWarning(
    "NAV_INVALID",
    {.severity = Severity::kAlarm,
     .raised_by = {"pNav"},
     .meaning = "There is no attitude, or nothing tells how the vehicle moves: NAV_STATE is not "
                "valid, NAV_X and its kin are silent, and pPilot stops.",
     .action =
         "See which of the other warnings of pNav stand: those sensors are to be brought back.",
     .clears = "Once attitude and one of bottom lock, depth and GPS are fresh."});

}  // namespace limpet::warnings
