// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace limpet {

/// `value` rounded to at most `decimals` places, without trailing zeros, and never `-0`: as MOOS's
/// own texts are written. What is no finite number gives 0.
[[nodiscard]] std::string DecimalText(double value, int decimals);

}  // namespace limpet
