// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {

/// Pressure depth of the body origin: white noise and a session's bias.
class DepthModel {
 public:
  struct Params {
    double noise_m = 0.02;
    double bias_sigma_m = 0.01;
  };
  DepthModel(const Params& params, Random random)
      : params_(params), random_(random), bias_(random_.Normal(params.bias_sigma_m)) {}

  [[nodiscard]] std::optional<double> Sample(const SimTruth& truth, Seconds) {
    return truth.down + bias_ + random_.Normal(params_.noise_m);
  }

 private:
  Params params_;
  Random random_;
  double bias_;
};

}  // namespace limpet
