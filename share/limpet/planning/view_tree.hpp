// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/objective.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/planning/seen_density.hpp"

namespace limpet {

struct ViewTreeParams {
  Meters turn_radius{3.0};
  int nodes = 100;            ///< budget
  Meters max_edge{10.0};      ///< longest motion between two views
  Meters rewire_radius{6.0};  ///< 0: no rewiring
  int offers = 5;
};

/// The tree of views of [Bucci 2025] (Algorithms 2-4, corrected as docs/references.md says): views
/// are sampled away from seen ground, joined by Dubins motions, rewired towards the better parent.
/// Offers its best branches under `objective`. Deterministic for equal `random`.
[[nodiscard]] std::vector<Option> ViewTree(const Pose2& start, const Ground& ground,
                                           const Region& region, const Objective& objective,
                                           const ViewTreeParams& params, Random& random);

}  // namespace limpet
