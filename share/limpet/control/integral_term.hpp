// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace limpet {

/// The integral part of a controller: bounded, and it stands still while its actuators cannot
/// follow and it would only push further.
class IntegralTerm {
 public:
  IntegralTerm(double gain, double limit) : gain_(gain), limit_(limit) {}

  /// What the integral adds after `dt` more of `error`; in the unit of `limit`.
  double Update(double error, double dt, bool is_saturated) {
    const double next = std::clamp(value_ + gain_ * error * dt, -limit_, limit_);
    if (!is_saturated || std::abs(next) < std::abs(value_)) value_ = next;
    return value_;
  }
  void Reset() { value_ = 0.0; }
  [[nodiscard]] double value() const { return value_; }

 private:
  double gain_;
  double limit_;
  double value_ = 0.0;
};

}  // namespace limpet
