// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/simulation/gyro_error.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// A single-axis fibre-optic gyro along body z: angular random walk and a bias that is constant
/// over a session, and what the scenario adds.
class FogModel {
 public:
  FogModel(const FogSheet& sheet, Random random, const GyroErrorParams& error = {})
      : random_(random),
        noise_(sheet.random_walk * std::sqrt(sheet.rate.value())),
        bias_(random_.Normal(RadiansFromDegrees(sheet.bias_deg_per_h) / 3600.0)),
        error_(error) {}

  /// Mean rate since the last sample [rad/s], so that its sum is the angle turned.
  [[nodiscard]] std::optional<double> Sample(const SimTruth& truth, Seconds now) {
    const double mean = last_rate_ ? 0.5 * (*last_rate_ + truth.r) : truth.r;
    last_rate_ = truth.r;
    return mean + bias_ + random_.Normal(noise_) + error_.Of(mean, now);
  }

 private:
  Random random_;
  double noise_;
  double bias_;
  GyroError error_;
  std::optional<double> last_rate_;
};

}  // namespace limpet
