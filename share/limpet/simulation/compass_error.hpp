// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "limpet/core/params.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Deviation of a magnetic compass: iron on board that turns with the vehicle.
struct CompassErrorParams {
  Radians constant{0.0}, sine{0.0}, cosine{0.0}, noise{0.0};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("deviation_deg", constant, "Deviation: the same on every heading",
          InRange(-45.0_deg, 45.0_deg));
    visit("deviation_sin_deg", sine, "Deviation: amplitude of the sine of the heading",
          InRange(-45.0_deg, 45.0_deg));
    visit("deviation_cos_deg", cosine, "Deviation: amplitude of the cosine of the heading",
          InRange(-45.0_deg, 45.0_deg));
    visit("heading_noise_deg", noise, "1-sigma of noise of one sample, on top of the sheet's",
          InRange(0.0_deg, 45.0_deg));
  }
};

class CompassError {
 public:
  CompassError(const CompassErrorParams& params, Random random)
      : params_(params), random_(random) {}

  /// What a heading is off [rad] where the true one is `yaw` [rad].
  [[nodiscard]] double Of(double yaw) {
    const double noise = params_.noise > Radians(0.0) ? random_.Normal(params_.noise.value()) : 0.0;
    return params_.constant.value() + params_.sine.value() * std::sin(yaw) +
           params_.cosine.value() * std::cos(yaw) + noise;
  }

 private:
  CompassErrorParams params_;
  Random random_;
};

}  // namespace limpet
