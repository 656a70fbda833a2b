// SPDX-License-Identifier: MIT
// What navigation believes of a vehicle's sensors: their data sheets, with margins. Nothing of it
// is known from a simulator.
#pragma once

#include "estimation/attitude/attitude_filter.hpp"
#include "estimation/navigation/navigator_params.hpp"
#include "limpet/core/units.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// Roll, pitch and yaw. Without a fibre-optic gyro the IMU's own yaw rate serves, with its errors.
[[nodiscard]] AttitudeParams BelievedAttitude(const SensorSheets& sheets);

/// Sets what the sheets tell of velocity, yaw rate, tilt, depth and fixes.
void BelieveSheets(const SensorSheets& sheets, NavigatorParams& params);

/// How far a DVL's velocity may be off, 1-sigma, constant over a session.
struct VelocityErrors {
  double scale = 0.0;         ///< share of the velocity
  double misalignment = 0.0;  ///< [rad]
  double bias_mps = 0.0;
};
/// Sets what these make of scale and misalignment: at a survey's steady speed a bias cannot be told
/// from them.
void BelieveVelocityErrors(const VelocityErrors& errors, OdometryParams& odometry);

/// Sets how well camera, DVL and gyro are known to sit, run and scale: what is not is estimated.
void BelieveMounting(const SensorSheets& sheets, NavigatorParams& params);

/// Sets where the antenna is, and so how deep the body lies where fixes come; and how fast a
/// vehicle may go of which nobody knows what it was told.
void BelieveHull(const VehicleParams& vehicle, NavigatorParams& params);

/// How hull and thrusters answer to commands, as the vehicle's file says; how much of it is true is
/// learnt at sea.
[[nodiscard]] DriveParams BelievedDrive(const VehicleParams& vehicle);

}  // namespace limpet
