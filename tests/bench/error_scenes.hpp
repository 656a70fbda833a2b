// SPDX-License-Identifier: MIT
// Worlds that are not as the data sheets say: one thing at a time, about twice what is believed or
// what a workshop leaves; the estimator is told nothing of it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/simulated_stream.hpp"

namespace limpet {

struct ErrorScene {
  std::string name;
  std::string meaning;
  StreamScene scene;
};

namespace error_scenes {

inline Radians Degrees(double degrees) { return Radians::FromTextUnit(degrees); }

inline void AddGeometry(const StreamScene& plain, std::vector<ErrorScene>& scenes) {
  StreamScene tilt = plain, lever = plain, mounting = plain, sizes = plain, sway = plain;
  tilt.errors.camera.mounting.pitch = Degrees(2.0);
  tilt.errors.camera.mounting.roll = Degrees(-1.0);
  lever.errors.camera.mounting.off_B = {0.1, -0.05, 0.05};
  lever.errors.dvl.mounting.off_B = {0.1, 0.05, 0.0};
  mounting.errors.dvl.mounting.yaw = Degrees(0.3);
  mounting.errors.dvl.mounting.pitch = Degrees(1.0);
  sizes.size_spread = 2.0;
  sway.motion.sway_W = {0.3, 0.2, 0.0};
  scenes.push_back({"tilt", "camera turned by 2 and 1 deg", tilt});
  scenes.push_back({"lever", "camera and DVL 0.1 m off", lever});
  scenes.push_back({"dvl_mounting", "DVL turned by 0.3 deg, pitched by 1 deg", mounting});
  scenes.push_back({"sizes", "objects of half to twice the radius", sizes});
  scenes.push_back({"sway", "objects sway by 0.3 m every 8 s", sway});
}

inline void AddTimes(const StreamScene& plain, std::vector<ErrorScene>& scenes) {
  StreamScene delay = plain, late = plain, shutter = plain;
  delay.errors.camera.stamps = {.delay = Seconds(0.15), .jitter = Seconds(0.02)};
  late.errors.camera.stamps = {.jitter = Seconds(0.02), .late_share = 0.05, .late = Seconds(0.5)};
  late.errors.dvl.stamps = {.jitter = Seconds(0.02), .late_share = 0.05, .late = Seconds(0.5)};
  late.errors.depth.stamps = late.errors.gps.stamps = late.errors.dvl.stamps;
  shutter.errors.camera.shutter.readout = Seconds(0.06);
  scenes.push_back({"delay", "camera's stamps 0.15 s late", delay});
  scenes.push_back({"late", "one stamp in twenty of DVL, depth, GPS and camera 0.5 s late", late});
  scenes.push_back({"shutter", "image read out in 0.06 s", shutter});
}

inline void AddHeadings(const StreamScene& plain, std::vector<ErrorScene>& scenes) {
  StreamScene compass = plain, ramp = plain;
  compass.errors.imu.compass = {
      .constant = Degrees(2.0), .sine = Degrees(2.0), .cosine = Degrees(1.0)};
  ramp.errors.fog.gyro = {.scale_error = 0.002, .drift_deg_per_h = 4.0};
  scenes.push_back(
      {"compass", "heading of a compass: 2 deg off, swinging by 2 deg as it turns", compass});
  scenes.push_back({"fog_ramp", "gyro warms up by 4 deg/h, 0.2 % of scale", ramp});
}

inline void AddRest(const StreamScene& plain, std::vector<ErrorScene>& scenes) {
  StreamScene beams = plain, bursts = plain, depth = plain, gps = plain, poor = plain, tide = plain,
              twice = plain;
  beams.errors.dvl.beams = {.loss_share = 0.1, .slope_bias = 0.1};
  bursts.errors.dvl.bursts = {.per_h = 20.0, .longest = Seconds(10.0)};
  depth.errors.depth.pressure = {.offset = Meters(0.3), .trend_m_per_h = 0.2};
  gps.errors.gps.multipath = {.walk = Meters(1.0), .jumps_per_h = 240.0};
  poor.true_fix_error = 4.0;
  tide.long_dropouts = 5;
  tide.current_mps = 0.3;
  tide.tide = TidalCurrentParams{.tide_period = Seconds(900.0),
                                 .tide_swing = Degrees(120.0),
                                 .tide_share = 0.5,
                                 .unrest_share = 0.1,
                                 .unrest = Seconds(120.0),
                                 .shear_per_m = 0.05};
  twice.true_noise = 2.0;
  twice.yaw_bias_degph = 4.0;
  scenes.push_back({"beams", "one DVL beam in ten lost, 10 % off per slope", beams});
  scenes.push_back({"false_velocity", "20 false velocities an hour, of 2 to 10 s", bursts});
  scenes.push_back({"pressure", "depth 0.3 m off, growing by 0.2 m an hour", depth});
  scenes.push_back({"gps_jumps", "fixes wander by 1 m and jump by 10 m", gps});
  scenes.push_back({"poor_fixes", "fixes wander by 2 m where 0.5 m is stated", poor});
  scenes.push_back({"tide", "current that swings in 15 minutes, five long dropouts", tide});
  scenes.push_back({"twice", "noise of DVL, depth, tilt and boxes twice the stated", twice});
}

}  // namespace error_scenes

/// Each as `plain` but for one error.
inline std::vector<ErrorScene> ErrorScenes(const StreamScene& plain) {
  std::vector<ErrorScene> scenes = {{"plain", "nothing", plain}};
  error_scenes::AddGeometry(plain, scenes);
  error_scenes::AddTimes(plain, scenes);
  error_scenes::AddHeadings(plain, scenes);
  error_scenes::AddRest(plain, scenes);
  return scenes;
}

}  // namespace limpet
