// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// ln(e^a + e^b) without overflow.
[[nodiscard]] inline double LogSum(double a, double b) {
  const double high = std::max(a, b);
  return high + std::log1p(std::exp(std::min(a, b) - high));
}

[[nodiscard]] inline PerVisibility LogSum(const PerVisibility& a, const PerVisibility& b) {
  return a.binaryExpr(b, [](double x, double y) { return LogSum(x, y); });
}

}  // namespace limpet
