// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/simulation/depth_error.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// Pressure depth of the body origin: white noise, a session's bias, and what the scenario adds.
class DepthModel {
 public:
  DepthModel(const DepthSheet& sheet, Random random, const DepthErrorParams& error = {})
      : sheet_(sheet), random_(random), bias_(random_.Normal(sheet.bias_m)), error_(error) {}

  [[nodiscard]] std::optional<double> Sample(const SimTruth& truth, Seconds now) {
    return truth.down + bias_ + random_.Normal(sheet_.noise_m) + error_.At(now);
  }

 private:
  DepthSheet sheet_;
  Random random_;
  double bias_;
  DepthError error_;
};

}  // namespace limpet
