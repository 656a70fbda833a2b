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

/// p ln p, which tends to 0 at 0.
[[nodiscard]] inline double PLogP(double p) { return p > 0.0 ? p * std::log(p) : 0.0; }

}  // namespace limpet
