// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// What a gyro's data sheet does not say of its rate.
struct GyroErrorParams {
  double scale_error = 0.0;
  double drift_deg_per_h = 0.0;
  Seconds drift_time{1800.0};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("scale_error", scale_error, "Share by which it overstates every turn",
          InRange(-0.1, 0.1));
    visit("drift_deg_per_h", drift_deg_per_h,
          "Bias that comes as it warms up, on top of the constant one [deg/h]",
          InRange(-3600.0, 3600.0));
    visit("drift_time_s", drift_time, "After this long 63 % of that bias have come",
          InRange(1.0_s, 100000.0_s));
  }
};

class GyroError {
 public:
  explicit GyroError(const GyroErrorParams& params) : params_(params) {}

  /// What comes on top of a true `rate` [rad/s] at `now`; it is cold when first asked.
  [[nodiscard]] double Of(double rate, Seconds now) {
    if (!start_) start_ = now;
    const double warmth = 1.0 - std::exp(-((now - *start_) / params_.drift_time));
    return params_.scale_error * rate +
           warmth * RadiansFromDegrees(params_.drift_deg_per_h) / 3600.0;
  }

 private:
  GyroErrorParams params_;
  std::optional<Seconds> start_;
};

}  // namespace limpet
