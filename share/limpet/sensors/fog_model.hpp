// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {

/// A single-axis fibre-optic gyro (KVH DSP-1760 class) along body z: angular random walk and a
/// bias that is constant over a session.
class FogModel {
 public:
  struct Params {
    double random_walk = 3.5e-6;  ///< [rad/sqrt(s)], 0.012 deg/sqrt(h)
    double bias_sigma_radps = RadiansFromDegrees(1.0) / 3600.0;
    Hertz rate{50.0};
  };
  FogModel(const Params& params, Random random)
      : random_(random),
        noise_(params.random_walk * std::sqrt(params.rate.value())),
        bias_(random_.Normal(params.bias_sigma_radps)) {}

  /// Mean rate since the last sample [rad/s], so that its sum is the angle turned.
  [[nodiscard]] std::optional<double> Sample(const SimTruth& truth, Seconds) {
    const double mean = last_rate_ ? 0.5 * (*last_rate_ + truth.r) : truth.r;
    last_rate_ = truth.r;
    return mean + bias_ + random_.Normal(noise_);
  }

 private:
  Random random_;
  double noise_;
  double bias_;
  std::optional<double> last_rate_;
};

}  // namespace limpet
