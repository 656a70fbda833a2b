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
  struct Gains {
    double gain = 0.0;
    double limit = 0.0;
  };
  explicit IntegralTerm(const Gains& gains) : gains_(gains) {}

  /// What the integral adds after `dt` more of `error`; in the unit of `limit`.
  double Update(double error, Seconds dt, bool is_saturated) {
    const double next =
        std::clamp(value_ + gains_.gain * error * dt.value(), -gains_.limit, gains_.limit);
    if (!is_saturated || std::abs(next) < std::abs(value_)) value_ = next;
    return value_;
  }
  void Reset() { value_ = 0.0; }
  [[nodiscard]] double value() const { return value_; }

 private:
  Gains gains_;
  double value_ = 0.0;
};

}  // namespace limpet
