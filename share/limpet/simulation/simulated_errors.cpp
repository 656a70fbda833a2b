// SPDX-License-Identifier: MIT
#include "limpet/simulation/simulated_errors.hpp"

#include <utility>

namespace limpet {
namespace {

template <class... Params>
KeySection Section(std::string name, Params&... params) {
  ParamCollector keys;
  (params.Describe(keys), ...);
  return {std::move(name), keys.specs()};
}

}  // namespace

std::vector<KeySection> ErrorSections(SimulatedErrors& errors) {
  auto& [camera, imu, fog, dvl, depth, gps, thrusters, battery] = errors;
  return {Section("camera", camera.mounting, camera.shutter, camera.stamps),
          Section("imu", imu.sheet, imu.gyro, imu.compass, imu.stamps),
          Section("fog", fog.sheet, fog.gyro, fog.stamps),
          Section("dvl", dvl.sheet, dvl.mounting, dvl.beams, dvl.bursts, dvl.stamps),
          Section("depth", depth.sheet, depth.pressure, depth.stamps),
          Section("gps", gps.multipath, gps.stamps),
          Section("thrusters", thrusters),
          Section("battery", battery)};
}

}  // namespace limpet
