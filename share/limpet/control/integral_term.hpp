// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "limpet/core/units.hpp"

namespace limpet {

/// The integral part of a controller: bounded, and it stands still while its actuators cannot
/// follow and it would only push further.
class IntegralTerm {
 public:
  struct Params {
    double gain = 0.0;
    double limit = 0.0;
  };
  explicit IntegralTerm(const Params& params) : params_(params) {}

  /// What the integral adds after `dt` more of `error`; in the unit of `limit`.
  double Update(double error, Seconds dt, bool is_saturated) {
    const double next =
        std::clamp(value_ + params_.gain * error * dt.value(), -params_.limit, params_.limit);
    if (!is_saturated || std::abs(next) < std::abs(value_)) value_ = next;
    return value_;
  }
  void Reset() { value_ = 0.0; }
  [[nodiscard]] double value() const { return value_; }

 private:
  Params params_;
  double value_ = 0.0;
};

}  // namespace limpet
