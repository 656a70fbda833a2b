// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>

namespace limpet {

/// 3 t^2 - 2 t^3: rises from 0 to 1 with no slope at either end. REQUIRES: t in [0, 1]; it is not
/// cut.
template <std::floating_point Real>
[[nodiscard]] constexpr Real SmoothStep(Real t) {
  return t * t * (static_cast<Real>(3) - static_cast<Real>(2) * t);
}

}  // namespace limpet
