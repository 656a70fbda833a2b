// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/objective.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/pass.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// Short paths that look at the targets, in the best order found: over the eight nearest, over
/// these and the eight nearest to where that ends, and so on, as long as looks are worth anything
/// so far ahead (Objective::target_decay_m). Empty without targets. For change sessions: former
/// objects first.
[[nodiscard]] std::vector<Option> TargetTours(const Pose2& start, const Region& region,
                                              const Objective& objective, Meters turn_radius);

/// The passes of the longest of these tours, each over or beside a target.
[[nodiscard]] std::vector<Pass> TargetPasses(const Pose2& start, const Region& region,
                                             const Objective& objective, Meters turn_radius);

/// Whether some pass over or beside the target stays inside the region and can be left again.
[[nodiscard]] bool CanBeLookedAt(const Target& target, const Region& region, Meters turn_radius);

}  // namespace limpet
