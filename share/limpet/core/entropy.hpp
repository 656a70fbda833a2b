// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace limpet {

/// -p ln p [nats], which tends to 0 at 0: what an outcome of this probability adds to an entropy.
[[nodiscard]] inline double MinusPLogP(double p) { return p > 0.0 ? -p * std::log(p) : 0.0; }

}  // namespace limpet
