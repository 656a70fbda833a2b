// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace limpet {

/// Rises from 0 at `low` to 1 at `high`.
[[nodiscard]] inline double Ramp(double value, double low, double high) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

}  // namespace limpet
