// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Pressure that is not the water's above the vehicle.
struct DepthErrorParams {
  Meters offset{0.0};
  double trend_m_per_h = 0.0;

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("offset_m", offset, "Air pressure and zero that nobody set: what every depth is too deep",
          InRange(-5.0_m, 5.0_m));
    visit("trend_m_per_h", trend_m_per_h,
          "Rate at which the offset grows: tide, weather, a sensor that creeps [m/h]",
          InRange(-5.0, 5.0));
  }
};

class DepthError {
 public:
  explicit DepthError(const DepthErrorParams& params) : params_(params) {}

  /// What a depth is too deep [m] at `now`; the trend begins when first asked.
  [[nodiscard]] double At(Seconds now) {
    if (!start_) start_ = now;
    return params_.offset.value() + params_.trend_m_per_h * (now - *start_).value() / 3600.0;
  }

 private:
  DepthErrorParams params_;
  std::optional<Seconds> start_;
};

}  // namespace limpet
