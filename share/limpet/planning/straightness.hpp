// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace limpet {

/// Whether a motion of this curvature [1/m] is flown as a straight line: a circle of its radius
/// would have no number of any use.
[[nodiscard]] inline bool IsStraight(double curvature) { return std::abs(curvature) < 1e-9; }

}  // namespace limpet
