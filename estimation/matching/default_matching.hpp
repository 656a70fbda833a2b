// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/matching/session_matching.hpp"

namespace limpet {

/// How pNav matches two sessions unless its mission says otherwise: each has fixes of its own, with
/// a slow error of their own.
[[nodiscard]] inline MatchingParams DefaultMatching() { return {.offset_sigma = Meters(0.8)}; }

}  // namespace limpet
