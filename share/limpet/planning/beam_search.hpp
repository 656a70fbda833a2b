// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/objective.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

struct BeamParams {
  Meters turn_radius{3.0};
  Meters horizon{25.0};
  Meters primitive{2.5};  ///< length of one motion: left, half left, straight, half right, right
  int width = 40;         ///< states kept per depth
  int offers = 16;        ///< options returned, at most
};

/// Beam search over Dubins primitives for the paths of the horizon's length that the objective
/// likes best. Every state on the way is inside the region and recoverable. Deterministic; its work
/// is bounded by width x 5 x horizon / primitive sweeps. If the start is not recoverable (drift,
/// current) the search first gets back: states that are less far outside are allowed.
/// Offers are alternatives: after the first ten metres no two are at the same place on the same
/// course. The best comes first, and is what a search for the best alone would find. Empty only if
/// nothing stays inside.
[[nodiscard]] std::vector<Option> BeamSearch(const Pose2& start, const Ground& ground,
                                             const Region& region, const Objective& objective,
                                             const BeamParams& params);

}  // namespace limpet
