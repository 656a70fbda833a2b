// SPDX-License-Identifier: MIT
#include "limpet/mission/fault_kinds.hpp"

#include <algorithm>
#include <array>

#include "limpet/mission/fault_names.hpp"

namespace limpet {
namespace {

// clang-format off
constexpr std::array<FaultKind, 39> kFaultKinds{{
    {"dvl_silent", "The DVL says nothing", "uSimSensors"},
    {"dvl_stuck", "The DVL repeats its last sample", "uSimSensors"},
    {fault_names::kDvlFlipped, "The DVL's velocity has the opposite sign ahead and aside", "uSimSensors"},
    {fault_names::kDvlBiased, "The DVL's velocity ahead is off", "uSimSensors", "so much too fast [m/s]", 0.3, -10.0, 10.0},
    {fault_names::kDvlNoLock, "The DVL answers without bottom lock", "uSimSensors"},
    {fault_names::kDvlOutliers, "Some of the DVL's velocities are anything up to 5 m/s off", "uSimSensors", "share of them", 0.4, 0.0, 1.0},
    {fault_names::kAltitudeStuck, "The DVL's altitude stays what it was", "uSimSensors"},
    {fault_names::kAltitudeBiased, "The DVL's altitude is off", "uSimSensors", "so much too high [m]", 3.0, -100.0, 100.0},
    {"depth_silent", "The depth sensor says nothing", "uSimSensors"},
    {"depth_stuck", "The depth sensor repeats its last value", "uSimSensors"},
    {fault_names::kDepthBiased, "The depth sensor is off", "uSimSensors", "so much too deep [m]", 2.0, -1000.0, 1000.0},
    {"imu_silent", "The IMU says nothing", "uSimSensors"},
    {"imu_stuck", "The IMU repeats its last sample", "uSimSensors"},
    {fault_names::kImuOutliers, "Some of the IMU's samples are glitches: rates, forces and heading of anything its line makes of them", "uSimSensors", "share of them", 0.2, 0.0, 1.0},
    {"fog_silent", "The fibre-optic gyro says nothing", "uSimSensors"},
    {"sonar_silent", "The obstacle sonar says nothing", "uSimSensors"},
    {"sonar_stuck", "The obstacle sonar repeats its last ping", "uSimSensors"},
    {"gps_silent", "The GPS receiver says nothing", "uSimSensors"},
    {fault_names::kGpsJump, "GPS fixes lie elsewhere", "uSimSensors", "so far north [m]", 50.0, -10000.0, 10000.0},
    {fault_names::kCameraSilent, "The camera makes no frames", "uSimCamera"},
    {fault_names::kFalseBoxes, "The boxes camera adds false detections to each frame; one of rendered pictures makes none, and warns of it", "uSimCamera", "so many a frame", 100.0, 1.0, 10000.0},
    {fault_names::kThrustersWeak, "Every thruster makes a share of its thrust", "uSimVehicle", "that share", 0.1, 0.0, 1.0},
    {fault_names::kCurrent, "A current sets in northwards, on top of the water's, by 0.2 m/s each second", "uSimVehicle", "so fast [m/s]", 2.0, -10.0, 10.0},
    {fault_names::kLeak, "LEAK is true; it is false else", "uSimVehicle"},
    {fault_names::kBattery, "BATTERY says this charge; a vehicle without a battery says that it is full else", "uSimVehicle", "share of a full one", 0.2, 0.0, 1.0},
    {fault_names::kGaugeStuck, "The battery's gauge repeats the charge that it said last", "uSimVehicle"},
    {fault_names::kCellsLost, "Some cells of the battery are shorted; the gauge does not know", "uSimVehicle", "share of its voltage and energy that is gone", 0.15, 0.0, 0.95},
    {fault_names::kBatteryLoad, "Something more draws on the battery", "uSimVehicle", "so much [W]", 300.0, 0.0, 10000.0},
    {fault_names::kLinkLost, "SHORE_BEAT stops; it comes each second else, from here", "uSimVehicle"},
    {fault_names::kClockStepped, "The wall clock is set, and set back when this is over: WALL_CLOCK says so", kMadeByHost, "so far ahead [s]", 3600.0, -1e9, 1e9},
    {.what = fault_names::kAppHangs, .meaning = "An app does nothing, in each life once it has begun: no tick, no mail", .made_by = kMadeByHost, .is_about_app = true},
    {.what = fault_names::kAppDown, .meaning = "An app has died and is not started again, says PLAUNCH_STATUS", .made_by = kMadeByHost, .is_about_app = true},
    {fault_names::kSlowPlanner, "Each decision of the helm on where next holds it up, says HELM_PLAN_TIME", kMadeByHost, "so long [s]", 8.0, 0.1, 600.0},
    {fault_names::kMemory, "The processes take so much memory together, says PLAUNCH_MEMORY", kMadeByHost, "so much [MiB]", 8000.0, 1.0, 1e7},
    {fault_names::kProcessor, "The busiest process takes so much of a core, says PLAUNCH_PROCESSOR", kMadeByHost, "so much [%]", 150.0, 1.0, 10000.0},
    {fault_names::kDiskLow, "The disk has so much room left", kMadeByHost, "so much [MiB]", 200.0, 0.0, 1e6},
    {fault_names::kDiskFull, "The disk takes half of a piece, then says that it is full", kMadeByHost},
    {fault_names::kDiskFailing, "The disk takes and syncs nothing, with an error of input and output", kMadeByHost},
    {fault_names::kDiskReadOnly, "The disk takes and syncs nothing, as one that the system has made read-only", kMadeByHost},
}};
// clang-format on

}  // namespace

std::span<const FaultKind> FaultKinds() { return kFaultKinds; }

const FaultKind* FindFaultKind(std::string_view what) {
  const auto* const found = std::ranges::find(kFaultKinds, what, &FaultKind::what);
  return found == kFaultKinds.end() ? nullptr : found;
}

}  // namespace limpet
