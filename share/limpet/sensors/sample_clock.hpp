// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "limpet/core/units.hpp"

namespace limpet {

/// Says which of the truth's instants a sensor of a given rate samples: the first, then the first
/// at or after each k / rate. Counting from the first sample, so that rounding never adds up.
class SampleClock {
 public:
  explicit SampleClock(Hertz rate) : rate_(rate) {}

  [[nodiscard]] bool IsDue(Seconds now) {
    if (!first_) first_ = now;
    const double periods = (now - *first_).value() * rate_.value();
    if (periods + kEarly < next_) return false;
    next_ = std::floor(periods + kEarly) + 1.0;
    return true;
  }

 private:
  static constexpr double kEarly = 1e-3;  // of a period: MOOS time is coarse
  Hertz rate_;
  std::optional<Seconds> first_;
  double next_ = 0.0;
};

}  // namespace limpet
