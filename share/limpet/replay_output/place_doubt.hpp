// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "estimation/replay/replay.hpp"

namespace limpet {

/// When the place was in doubt while the session ran, beside what the start is.
struct PlaceDoubt {
  double seconds = 0.0;         ///< all together
  double sigma = 0.0, t = 0.0;  ///< the worst 1-sigma of an axis [m], and when
};

/// Nothing if the place was always known to `high` (1-sigma of an axis [m]) or better. What the
/// start itself is in doubt does not count, nor what comes before the first fix.
[[nodiscard]] std::optional<PlaceDoubt> WorstDoubt(const ReplayResult& result, double high);

}  // namespace limpet
