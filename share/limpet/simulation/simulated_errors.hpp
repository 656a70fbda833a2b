// SPDX-License-Identifier: MIT
// What differs from the vehicle's data sheets, sensor by sensor: nothing, unless a scenario says
// so. One model per file; both the simulated vehicle and simulated sensor streams are made of them.
#pragma once

#include <string>
#include <vector>

#include "limpet/core/key_section.hpp"
#include "limpet/core/params.hpp"
#include "limpet/simulation/battery_error.hpp"
#include "limpet/simulation/beam_error.hpp"
#include "limpet/simulation/compass_error.hpp"
#include "limpet/simulation/depth_error.hpp"
#include "limpet/simulation/false_velocity.hpp"
#include "limpet/simulation/gps_error.hpp"
#include "limpet/simulation/gyro_error.hpp"
#include "limpet/simulation/mounting_error.hpp"
#include "limpet/simulation/rolling_shutter.hpp"
#include "limpet/simulation/sheet_error.hpp"
#include "limpet/simulation/stamp_error.hpp"
#include "limpet/simulation/thruster_error.hpp"

namespace limpet {

struct SimulatedErrors {
  struct Camera {
    MountingErrorParams mounting;
    RollingShutterParams shutter;
    StampErrorParams stamps;
  } camera;
  struct Imu {
    SheetErrorParams sheet;
    GyroErrorParams gyro;
    CompassErrorParams compass;
    StampErrorParams stamps;
  } imu;
  struct Fog {
    SheetErrorParams sheet;
    GyroErrorParams gyro;
    StampErrorParams stamps;
  } fog;
  struct Dvl {
    SheetErrorParams sheet;
    MountingErrorParams mounting;
    BeamErrorParams beams;
    FalseVelocityParams bursts;
    StampErrorParams stamps;
  } dvl;
  struct Depth {
    SheetErrorParams sheet;
    DepthErrorParams pressure;
    StampErrorParams stamps;
  } depth;
  struct Gps {
    GpsErrorParams multipath;
    StampErrorParams stamps;
  } gps;
  ThrusterErrorParams thrusters;
  BatteryErrorParams battery;
};

/// Sections of `errors:` in scenario.yaml. The keys store into `errors`.
[[nodiscard]] std::vector<KeySection> ErrorSections(SimulatedErrors& errors);

}  // namespace limpet
