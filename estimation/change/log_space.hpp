// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace limpet {

/// ln(e^a + e^b) without overflow.
[[nodiscard]] inline double LogSum(double a, double b) {
  const double high = std::max(a, b);
  return high + std::log1p(std::exp(std::min(a, b) - high));
}

}  // namespace limpet
