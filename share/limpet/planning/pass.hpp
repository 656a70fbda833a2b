// SPDX-License-Identifier: MIT
// Straight passes over something, and the motions that join them.
#pragma once

#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/dubins_word.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// Length by which passes are shortened at borders, at a time [m].
inline constexpr double kPassCut = 0.25;

/// One way to pass a place: in at `in`, straight on for `length`.
struct Pass {
  Pose2 in;
  double length = 0.0;  ///< [m]
  [[nodiscard]] Pose2 out() const { return Advance(in, {.curvature = 0.0, .length = length}); }
  /// The pass over this ground that is flown the other way.
  [[nodiscard]] Pass Reversed() const;
  [[nodiscard]] bool operator==(const Pass& other) const;
};
[[nodiscard]] bool IsInside(const Pass& pass, const Region& region);

/// Something to visit, by any one of its passes. REQUIRES: at least one.
using Stop = std::vector<Pass>;

/// The motion that leads from one pose to another.
struct PassLink {
  DubinsWord word;
  bool is_inside = true;  ///< false: no word stays inside the region; this is the shortest of all

  /// What searches count it for [m]: one that leaves the region only if nothing else is left.
  [[nodiscard]] double Price() const;
};
[[nodiscard]] PassLink LinkBetween(const Pose2& from, const Pose2& to, const Region& region,
                                   Meters turn_radius);

}  // namespace limpet
