// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// Pressure depth of the body origin: white noise and a session's bias.
class DepthModel {
 public:
  DepthModel(const DepthSheet& sheet, Random random)
      : sheet_(sheet), random_(random), bias_(random_.Normal(sheet.bias_m)) {}

  [[nodiscard]] std::optional<double> Sample(const SimTruth& truth, Seconds) {
    return truth.down + bias_ + random_.Normal(sheet_.noise_m);
  }

 private:
  DepthSheet sheet_;
  Random random_;
  double bias_;
};

}  // namespace limpet
