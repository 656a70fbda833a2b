// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// Whether the vehicle truly stayed where it was to stay.
struct FenceScore {
  /// Farthest outside the operating region while it surveyed, once it was inside [m].
  double outside_region_m = 0.0;
  /// Farthest into a keep-out zone, at any time [m].
  double inside_zone_m = 0.0;
};

/// Nothing without an area. REQUIRES: a track of the truth that is not empty.
[[nodiscard]] std::optional<FenceScore> ScoreFences(const SessionRecord& record);

}  // namespace limpet
