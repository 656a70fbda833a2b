// SPDX-License-Identifier: MIT
#include "limpet/mission/fault_kinds.hpp"

#include <algorithm>
#include <array>

namespace limpet {
namespace {

// clang-format off
constexpr std::array<FaultKind, 39> kFaultKinds{{
    {"dvl_silent", "The DVL says nothing", "uSimSensors"},
    {"dvl_stuck", "The DVL repeats its last sample", "uSimSensors"},
    {"dvl_flipped", "The DVL's velocity has the opposite sign ahead and aside", "uSimSensors"},
    {"dvl_biased", "The DVL's velocity ahead is off", "uSimSensors", "so much too fast [m/s]", 0.3, -10.0, 10.0},
    {"dvl_no_lock", "The DVL answers without bottom lock", "uSimSensors"},
    {"dvl_outliers", "Some of the DVL's velocities are anything up to 5 m/s off", "uSimSensors", "share of them", 0.4, 0.0, 1.0},
    {"altitude_stuck", "The DVL's altitude stays what it was", "uSimSensors"},
    {"altitude_biased", "The DVL's altitude is off", "uSimSensors", "so much too high [m]", 3.0, -100.0, 100.0},
    {"depth_silent", "The depth sensor says nothing", "uSimSensors"},
    {"depth_stuck", "The depth sensor repeats its last value", "uSimSensors"},
    {"depth_biased", "The depth sensor is off", "uSimSensors", "so much too deep [m]", 2.0, -1000.0, 1000.0},
    {"imu_silent", "The IMU says nothing", "uSimSensors"},
    {"imu_stuck", "The IMU repeats its last sample", "uSimSensors"},
    {"imu_outliers", "Some of the IMU's samples are glitches: rates, forces and heading of anything its line makes of them", "uSimSensors", "share of them", 0.2, 0.0, 1.0},
    {"fog_silent", "The fibre-optic gyro says nothing", "uSimSensors"},
    {"sonar_silent", "The obstacle sonar says nothing", "uSimSensors"},
    {"sonar_stuck", "The obstacle sonar repeats its last ping", "uSimSensors"},
    {"gps_silent", "The GPS receiver says nothing", "uSimSensors"},
    {"gps_jump", "GPS fixes lie elsewhere", "uSimSensors", "so far north [m]", 50.0, -10000.0, 10000.0},
    {"camera_silent", "The camera makes no frames", "uSimCamera"},
    {"false_boxes", "The boxes camera adds false detections to each frame; one of rendered pictures makes none, and warns of it", "uSimCamera", "so many a frame", 100.0, 1.0, 10000.0},
    {"thrusters_weak", "Every thruster makes a share of its thrust", "uSimVehicle", "that share", 0.1, 0.0, 1.0},
    {"current", "A current sets in northwards, on top of the water's, by 0.2 m/s each second", "uSimVehicle", "so fast [m/s]", 2.0, -10.0, 10.0},
    {"leak", "LEAK is true; it is false else", "uSimVehicle"},
    {"battery", "BATTERY says this charge; a vehicle without a battery says that it is full else", "uSimVehicle", "share of a full one", 0.2, 0.0, 1.0},
    {"gauge_stuck", "The battery's gauge repeats the charge that it said last", "uSimVehicle"},
    {"cells_lost", "Some cells of the battery are shorted; the gauge does not know", "uSimVehicle", "share of its voltage and energy that is gone", 0.15, 0.0, 0.95},
    {"battery_load", "Something more draws on the battery", "uSimVehicle", "so much [W]", 300.0, 0.0, 10000.0},
    {"link_lost", "SHORE_BEAT stops; it comes each second else, from here", "uSimVehicle"},
    {"clock_stepped", "The wall clock is set, and set back when this is over: WALL_CLOCK says so", kMadeByHost, "so far ahead [s]", 3600.0, -1e9, 1e9},
    {.what = "app_hangs", .meaning = "An app does nothing, in each life once it has begun: no tick, no mail", .made_by = kMadeByHost, .is_about_app = true},
    {.what = "app_down", .meaning = "An app has died and is not started again, says PLAUNCH_STATUS", .made_by = kMadeByHost, .is_about_app = true},
    {"slow_planner", "Each decision of the helm on where next holds it up, says HELM_PLAN_TIME", kMadeByHost, "so long [s]", 8.0, 0.1, 600.0},
    {"memory", "The processes take so much memory together, says PLAUNCH_MEMORY", kMadeByHost, "so much [MiB]", 8000.0, 1.0, 1e7},
    {"processor", "The busiest process takes so much of a core, says PLAUNCH_PROCESSOR", kMadeByHost, "so much [%]", 150.0, 1.0, 10000.0},
    {"disk_low", "The disk has so much room left", kMadeByHost, "so much [MiB]", 200.0, 0.0, 1e6},
    {"disk_full", "The disk takes half of a piece, then says that it is full", kMadeByHost},
    {"disk_failing", "The disk takes and syncs nothing, with an error of input and output", kMadeByHost},
    {"disk_read_only", "The disk takes and syncs nothing, as one that the system has made read-only", kMadeByHost},
}};
// clang-format on

}  // namespace

std::span<const FaultKind> FaultKinds() { return kFaultKinds; }

const FaultKind* FindFaultKind(std::string_view what) {
  const auto* const found = std::ranges::find(kFaultKinds, what, &FaultKind::what);
  return found == kFaultKinds.end() ? nullptr : found;
}

}  // namespace limpet
