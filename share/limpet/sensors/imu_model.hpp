// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/simulation/compass_error.hpp"
#include "limpet/simulation/gauss_markov.hpp"
#include "limpet/simulation/gyro_error.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// An inertial unit at the body origin: white noise and constant biases on
/// accelerations and rates. Its magnetic heading has an error that hardly changes within a session
/// (declination, hard iron) with a little slow and white noise on top.
class ImuModel {
 public:
  struct Params {
    ImuSheet sheet;
    double heading_slow_sigma_rad = RadiansFromDegrees(0.1);  ///< correlated over heading_slow
    Seconds heading_slow{60.0};
    double heading_noise_rad = RadiansFromDegrees(0.1);
    CompassErrorParams compass{};
    GyroErrorParams gyro{};  ///< of the rate about body z
  };
  ImuModel(const Params& params, Random random, Random errors = Random(0));
  [[nodiscard]] std::optional<ImuSample> Sample(const SimTruth& truth, Seconds now);

 private:
  [[nodiscard]] Eigen::Vector3d Noise(double sigma);

  Params params_;
  Random random_;
  Eigen::Vector3d accel_bias_;
  Eigen::Vector3d gyro_bias_;
  double heading_offset_;
  GaussMarkov heading_slow_;
  CompassError compass_;
  GyroError gyro_;
};

}  // namespace limpet
