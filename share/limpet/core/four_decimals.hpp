// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace limpet {

/// The nearest number of four decimals, halves away from zero: what metres, seconds and radians are
/// told with where a tenth of a millimetre is enough and text is to stay short. Minus zero and what
/// is no number stay what they are.
[[nodiscard]] inline double ToFourDecimals(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace limpet
