// SPDX-License-Identifier: MIT
// What the data sheets of a vehicle's sensors say. A vehicle's file (share/vehicles) gives them;
// the defaults are of a FeelHippo-class vehicle and stand for what a file leaves out. The simulator
// builds such sensors, and a scenario may make them worse; what navigates believes the sheets with
// margins of its own (estimation/navigation/sensor_beliefs.hpp) and knows no scenario.
#pragma once

#include <Eigen/Core>

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// How often a sensor may measure. The simulator's truth comes at 50 Hz: no sensor is faster there.
inline Range<Hertz> SensorRates() { return InRange(Hertz(0.1), Hertz(1000.0)); }

/// Inertial unit at the body origin; noise of one sample.
struct ImuSheet {
  bool is_present = true;
  Hertz rate{50.0};
  double gyro_noise_radps = 5e-4;
  double gyro_bias_radps = 2e-4;
  double force_noise_mps2 = 0.01;
  double gyro_scale_sigma = 0.002;
  double force_bias_mps2 = 0.02;  ///< 0.12 deg of roll and pitch
  Radians heading_sigma = Radians::FromTextUnit(0.5);

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("present", is_present, "Whether there is one; pNav needs it");
    visit("rate_hz", rate, "Samples per second", SensorRates());
    visit("gyro_noise_radps", gyro_noise_radps, "Noise of one sample of each rate [rad/s]",
          InRange(0.0, 1.0));
    visit("gyro_bias_radps", gyro_bias_radps, "Bias of each rate, constant over a session [rad/s]",
          InRange(0.0, 1.0));
    visit("gyro_scale_sigma", gyro_scale_sigma,
          "1-sigma of the scale of the rates; counts without a fog", InRange(0.0, 0.1));
    visit("force_noise_mps2", force_noise_mps2,
          "Noise of one sample of each specific force [m/s^2]", InRange(0.0, 10.0));
    visit("force_bias_mps2", force_bias_mps2,
          "Bias of each specific force, constant over a session [m/s^2]", InRange(0.0, 10.0));
    visit("heading_sigma_deg", heading_sigma,
          "1-sigma of the magnetic heading's error, hardly changing over a session",
          InRange(0.01_deg, 30.0_deg));
  }
};

/// Fibre-optic gyro along body z.
struct FogSheet {
  bool is_present = true;
  Hertz rate{50.0};
  double random_walk = 3.5e-6;  ///< [rad/sqrt(s)], 0.012 deg/sqrt(h)
  double bias_deg_per_h = 1.0;
  double scale_sigma = 0.0005;

  template <class V>
  void Describe(V& visit) {
    visit("present", is_present, "Whether there is one; without, the IMU's own yaw rate serves");
    visit("rate_hz", rate, "Samples per second", SensorRates());
    visit("random_walk_rad_per_sqrt_s", random_walk,
          "Angular random walk [rad/sqrt(s)]: that in deg/sqrt(h) times 2.909e-4",
          InRange(0.0, 0.01));
    visit("bias_deg_per_h", bias_deg_per_h, "Bias, constant over a session [deg/h]",
          InRange(0.0, 3600.0));
    visit("scale_sigma", scale_sigma, "1-sigma of the rate's scale", InRange(0.0, 0.1));
  }
};

/// Doppler velocity log: four beams at 45, 135, 225, 315 deg clockwise from its own forward.
struct DvlSheet {
  Eigen::Vector3d p_BD{-0.2, 0.0, 0.18};
  Meters lever_sigma{0.02};
  Radians yaw{0.0};
  Radians beam_angle = Radians::FromTextUnit(25.0);
  Hertz rate{5.0};
  double noise_mps = 0.01;
  double vertical_noise_mps = 0.005;
  double scale_sigma = 0.002;
  Radians misalignment_sigma = Radians::FromTextUnit(0.15);
  double bias_mps = 0.001;
  double range_noise_m = 0.01;
  double range_noise_share = 0.002;
  Meters least_altitude{0.3};
  Meters greatest_altitude{50.0};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("at_m", p_BD, "m", "Where it is, from the body origin", InRange(-10.0, 10.0));
    visit("lever_sigma_m", lever_sigma, "1-sigma of how well that is known, ahead and to starboard",
          InRange(0.0_m, 1.0_m));
    visit("yaw_deg", yaw, "How its forward is turned from the vehicle's, clockwise from above",
          InRange(-180.0_deg, 180.0_deg));
    visit("beam_angle_deg", beam_angle, "Of its four beams from its vertical",
          InRange(5.0_deg, 45.0_deg));
    visit("rate_hz", rate, "Pings per second", SensorRates());
    visit("noise_mps", noise_mps, "Noise of one ping's velocity, horizontal [m/s]",
          InRange(1e-4, 1.0));
    visit("vertical_noise_mps", vertical_noise_mps, "Noise of one ping's velocity, vertical [m/s]",
          InRange(1e-4, 1.0));
    visit("scale_sigma", scale_sigma, "1-sigma of the velocity's scale, constant over a session",
          InRange(0.0, 0.2));
    visit("misalignment_sigma_deg", misalignment_sigma,
          "1-sigma of its mounting's error about the vertical, constant over a session",
          InRange(0.0_deg, 20.0_deg));
    visit("bias_mps", bias_mps, "Bias of each velocity, constant over a session [m/s]",
          InRange(0.0, 0.5));
    visit("range_noise_m", range_noise_m, "Noise of a beam's range [m]", InRange(0.0, 5.0));
    visit("range_noise_share", range_noise_share, "Share of the range that comes on top",
          InRange(0.0, 0.2));
    visit("least_altitude_m", least_altitude, "No bottom lock below it", InRange(0.0_m, 100.0_m));
    visit("greatest_altitude_m", greatest_altitude, "No bottom lock above it",
          InRange(0.5_m, 1000.0_m));
  }
};

/// Pressure, as depth of the body origin.
struct DepthSheet {
  Hertz rate{20.0};
  double noise_m = 0.02;
  double bias_m = 0.01;
  Meters bias_sigma{0.15};
  double drift_m_per_sqrt_h = 0.05;

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("rate_hz", rate, "Samples per second", SensorRates());
    visit("noise_m", noise_m, "Noise of one sample [m]", InRange(0.0, 5.0));
    visit("bias_m", bias_m, "Bias, constant over a session [m]", InRange(0.0, 5.0));
    visit(
        "bias_sigma_m", bias_sigma,
        "1-sigma of what its zero and the air's pressure leave, on top; 0: pNav does not estimate "
        "it",
        InRange(0.0_m, 5.0_m));
    visit("drift_m_per_sqrt_h", drift_m_per_sqrt_h,
          "1-sigma of how that changes within an hour: tide, weather, creep [m/sqrt(h)]",
          InRange(0.0, 2.0));
  }
};

/// GPS; its antenna is a part of the hull.
struct GpsSheet {
  Hertz rate{1.0};
  double sigma_m = 0.4;
  double noise_m = 0.05;
  Seconds correlation{120.0};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("rate_hz", rate, "Fixes per second", SensorRates());
    visit("sigma_m", sigma_m, "1-sigma of each horizontal axis [m]", InRange(0.001, 100.0));
    visit("noise_m", noise_m, "What of it differs from one fix to the next [m]",
          InRange(0.0, 100.0));
    visit("correlation_s", correlation, "The rest stays the same for about this long",
          InRange(0.1_s, 3600.0_s));
  }
};

/// How well the camera's place on the body and its clock are known.
struct CameraMountSheet {
  Radians tilt_sigma = Radians::FromTextUnit(1.0);
  Meters lever_sigma{0.03};
  Seconds delay_sigma{0.1};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit(
        "tilt_sigma_deg", tilt_sigma,
        "1-sigma of how well its direction is known, about each axis; 0: pNav does not estimate it",
        InRange(0.0_deg, 10.0_deg));
    visit("lever_sigma_m", lever_sigma, "1-sigma of how well at_m is known, ahead and to starboard",
          InRange(0.0_m, 1.0_m));
    visit("delay_sigma_s", delay_sigma, "1-sigma of how late its stamps are",
          InRange(0.0_s, 2.0_s));
  }
};

/// Fan of narrow beams, level with the vehicle, that look ahead for what stands up.
struct SonarSheet {
  bool is_present = false;
  Eigen::Vector3d p_BS{0.3, 0.0, 0.0};
  Hertz rate{4.0};
  int beams = 61;
  Radians fan = Radians::FromTextUnit(130.0);
  Meters least_range{0.3};
  Meters greatest_range{15.0};
  double range_noise_m = 0.05;

  /// Bearing of the outermost beam to port, clockwise from ahead, and angle between two beams
  /// [rad].
  [[nodiscard]] double first_bearing() const { return -0.5 * fan.value(); }
  [[nodiscard]] double bearing_step() const { return fan.value() / (beams - 1); }

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("present", is_present, "Whether there is one; without, obstacles show to DVL beams only");
    visit("at_m", p_BS, "m", "Where it is, from the body origin", InRange(-10.0, 10.0));
    visit("rate_hz", rate, "Pings per second", SensorRates());
    visit("beams", beams, "Beams of the fan, from port to starboard", InRange(2, 512));
    visit("fan_deg", fan, "Angle between the outermost two", InRange(1.0_deg, 180.0_deg));
    visit("least_range_m", least_range, "Nothing nearer gives an echo", InRange(0.0_m, 10.0_m));
    visit("greatest_range_m", greatest_range, "Nothing farther does", InRange(1.0_m, 200.0_m));
    visit("range_noise_m", range_noise_m, "Noise of an echo's range [m]", InRange(0.0, 5.0));
  }
};

struct SensorSheets {
  ImuSheet imu;
  FogSheet fog;
  DvlSheet dvl;
  DepthSheet depth;
  GpsSheet gps;
  SonarSheet sonar;
  CameraMountSheet camera_mount;
};

}  // namespace limpet
