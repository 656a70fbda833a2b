// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

struct PaperTreeParams {
  Meters turn_radius{3.0};
  int nodes = 100;
  Meters max_edge{4.0};  ///< of 3 to 15 m this served the paper's planner best
};

/// The tree of views of [Bucci 2025] as printed, P0 of docs/references.md: no rewiring, grown from
/// `kept`, the views that were left of the branch chosen last. One option per view of the tree, in
/// the order in which they were added: its path is the motion to the branch's first view, its
/// `views` are all of the branch. Every motion is inside the region and can be left again.
[[nodiscard]] std::vector<Option> PaperTree(const Pose2& start, const std::vector<Pose2>& kept,
                                            const Ground& ground, const Region& region,
                                            const PaperTreeParams& params, Random& random);

}  // namespace limpet
