// SPDX-License-Identifier: MIT
// How scenarios name what may fail, for the table of faults and for those that make them. Not here:
// `<sensor>_silent` and `<sensor>_stuck`, which FaultySensor makes of its sensor's name.
#pragma once

#include <string_view>

namespace limpet::fault_names {

inline constexpr std::string_view kDvlFlipped = "dvl_flipped";
inline constexpr std::string_view kDvlBiased = "dvl_biased";
inline constexpr std::string_view kDvlNoLock = "dvl_no_lock";
inline constexpr std::string_view kDvlOutliers = "dvl_outliers";
inline constexpr std::string_view kAltitudeStuck = "altitude_stuck";
inline constexpr std::string_view kAltitudeBiased = "altitude_biased";
inline constexpr std::string_view kDepthBiased = "depth_biased";
inline constexpr std::string_view kImuOutliers = "imu_outliers";
inline constexpr std::string_view kGpsJump = "gps_jump";
inline constexpr std::string_view kCameraSilent = "camera_silent";
inline constexpr std::string_view kFalseBoxes = "false_boxes";
inline constexpr std::string_view kThrustersWeak = "thrusters_weak";
inline constexpr std::string_view kCurrent = "current";
inline constexpr std::string_view kLeak = "leak";
inline constexpr std::string_view kBattery = "battery";
inline constexpr std::string_view kGaugeStuck = "gauge_stuck";
inline constexpr std::string_view kCellsLost = "cells_lost";
inline constexpr std::string_view kBatteryLoad = "battery_load";
inline constexpr std::string_view kLinkLost = "link_lost";
inline constexpr std::string_view kClockStepped = "clock_stepped";
inline constexpr std::string_view kAppHangs = "app_hangs";
inline constexpr std::string_view kAppDown = "app_down";
inline constexpr std::string_view kSlowPlanner = "slow_planner";
inline constexpr std::string_view kMemory = "memory";
inline constexpr std::string_view kProcessor = "processor";
inline constexpr std::string_view kDiskLow = "disk_low";
inline constexpr std::string_view kDiskFull = "disk_full";
inline constexpr std::string_view kDiskFailing = "disk_failing";
inline constexpr std::string_view kDiskReadOnly = "disk_read_only";

}  // namespace limpet::fault_names
