// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "limpet/core/interval.hpp"

namespace limpet {

/// Rises from 0 at the low end of `over` to 1 at its high one.
[[nodiscard]] inline double Ramp(double value, const Interval& over) {
  return std::clamp((value - over.low) / (over.high - over.low), 0.0, 1.0);
}

}  // namespace limpet
