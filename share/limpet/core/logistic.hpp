// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace limpet {

/// The probability whose log odds are `logit`.
[[nodiscard]] inline double Logistic(double logit) { return 1.0 / (1.0 + std::exp(-logit)); }

}  // namespace limpet
