// SPDX-License-Identifier: MIT
#include "estimation/navigation/sensor_beliefs.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/gravity.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {
namespace {

// Data sheets are made in a laboratory, and a vehicle shakes, warms up and was mounted by hand.
constexpr double kNoiseMargin = 1.2;    // of a DVL's velocity
constexpr double kFogBiasMargin = 2.0;  // of a bias at one temperature
constexpr double kGyroNoiseMargin =
    4.0;  // thrusters shake the IMU; over one second, not one sample
constexpr double kGyroBiasMargin = 25.0;  // from one start to the next, before anything tells it
constexpr double kTiltMargin = 2.3;       // of the tilt that a bias of the force makes
constexpr double kDepthMargin = 1.4;
constexpr double kHullMargin = 1.2;     // of how deep a vehicle floats: trim and load
constexpr double kHeadingMargin = 1.5;  // a compass is calibrated elsewhere, with other things on

/// A belief has two digits: nobody knows more of a sensor's errors.
double TwoDigits(double value) {
  if (value <= 0.0) return 0.0;
  const double digits = 1.0 - std::floor(std::log10(value));
  const double scale = std::pow(10.0, std::abs(digits));
  return digits >= 0.0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

struct YawRateErrors {
  double walk = 0.0;  ///< over one second [rad/sqrt(s)]
  double bias = 0.0;  ///< [rad/s]
};

YawRateErrors BelievedYawRate(const SensorSheets& sheets) {
  if (sheets.fog.is_present) {
    const double bias = RadiansFromDegrees(sheets.fog.bias_deg_per_h) / 3600.0;
    return {.walk = TwoDigits(sheets.fog.random_walk), .bias = TwoDigits(kFogBiasMargin * bias)};
  }
  const ImuSheet& imu = sheets.imu;
  return {.walk = TwoDigits(kGyroNoiseMargin * imu.gyro_noise_radps / std::sqrt(imu.rate.value())),
          .bias = TwoDigits(kFogBiasMargin * imu.gyro_bias_radps)};
}

/// The tilt of the horizon that a bias of the force makes, as believed.
Radians BelievedTilt(const ImuSheet& imu) {
  return Radians(TwoDigits(kTiltMargin * imu.force_bias_mps2 / kGravity));
}

}  // namespace

AttitudeParams BelievedAttitude(const SensorSheets& sheets) {
  const ImuSheet& imu = sheets.imu;
  const YawRateErrors yaw = BelievedYawRate(sheets);
  AttitudeParams params;
  params.gyro_noise = Radians(TwoDigits(kGyroNoiseMargin * imu.gyro_noise_radps));
  params.gyro_bias_sigma = Radians(TwoDigits(kGyroBiasMargin * imu.gyro_bias_radps));
  params.tilt_floor = BelievedTilt(imu);
  params.heading_sigma = kHeadingMargin * imu.heading_sigma;
  params.yaw_random_walk = Radians(yaw.walk);
  params.yaw_bias_sigma = Radians(yaw.bias);
  return params;
}

void BelieveMounting(const SensorSheets& sheets, NavigatorParams& params) {
  const CameraMountSheet& camera = sheets.camera_mount;
  params.objects.mount = {.tilt_sigma = camera.tilt_sigma.value(),
                          .lever_sigma = camera.lever_sigma.value(),
                          .delay_sigma = camera.delay_sigma.value()};
  params.odometry.dvl_lever_sigma = sheets.dvl.lever_sigma.value();
  params.odometry.gyro_scale_sigma =
      sheets.fog.is_present ? sheets.fog.scale_sigma : sheets.imu.gyro_scale_sigma;
}

void BelieveHull(const VehicleParams& vehicle, NavigatorParams& params) {
  params.antenna_B = vehicle.antenna_B;
  params.odometry.water.speed_sigma = 0.5 * vehicle.top_speed.value();
  // Anywhere between the body's origin and the antenna at the surface, alike.
  const double height = std::max(-vehicle.antenna_B.z(), 0.0);
  params.surface_depth = Meters(TwoDigits(0.5 * height));
  params.surface_depth_sigma = Meters(TwoDigits(kHullMargin * height / std::sqrt(12.0)));
}

static_assert(kMostThrusters == static_cast<int>(ThrusterShares::kMost));

DriveParams BelievedDrive(const VehicleParams& vehicle) {
  const Hydrodynamics hydro = DeriveHydrodynamics(vehicle);
  return {.mass_B = hydro.mass_matrix.diagonal().head<2>(),
          .linear_drag_B = hydro.linear_drag.head<2>(),
          .quadratic_drag_B = hydro.quadratic_drag.head<2>(),
          .full_thrust_B =
              vehicle.thrusters.max_thrust_n * vehicle.thrusters.WrenchPerThrust().topRows<2>()};
}

void BelieveVelocityErrors(const VelocityErrors& errors, OdometryParams& odometry) {
  constexpr MetersPerSecond kSurveySpeed(0.5);
  const double bias = errors.bias_mps / kSurveySpeed.value();
  odometry.scale_sigma = std::hypot(errors.scale, bias);
  odometry.misalign_sigma = std::hypot(errors.misalignment, bias);
}

void BelieveSheets(const SensorSheets& sheets, NavigatorParams& params) {
  const DvlSheet& dvl = sheets.dvl;
  OdometryParams& odometry = params.odometry;
  odometry.dvl_B = dvl.p_BD;
  odometry.velocity_noise = TwoDigits(kNoiseMargin * dvl.noise_mps);
  odometry.velocity_period = Seconds(1.0 / dvl.rate.value());
  BelieveVelocityErrors({.scale = dvl.scale_sigma,
                         .misalignment = dvl.misalignment_sigma.value(),
                         .bias_mps = dvl.bias_mps},
                        odometry);
  odometry.scale_sigma = TwoDigits(odometry.scale_sigma);
  odometry.misalign_sigma = TwoDigits(odometry.misalign_sigma);
  const YawRateErrors yaw = BelievedYawRate(sheets);
  odometry.yaw_walk = yaw.walk;
  odometry.yaw_bias = yaw.bias;
  params.tilt_sigma = BelievedTilt(sheets.imu);
  const double second = sheets.depth.noise_m / std::sqrt(sheets.depth.rate.value());
  params.depth_sigma = Meters(TwoDigits(kDepthMargin * std::hypot(sheets.depth.bias_m, second)));
  params.depth_bias_sigma = sheets.depth.bias_sigma;
  params.depth_bias_drift = sheets.depth.drift_m_per_sqrt_h;
  params.gps_correlation = sheets.gps.correlation;
  BelieveMounting(sheets, params);
}

}  // namespace limpet
