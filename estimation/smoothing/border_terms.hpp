// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/smoothing/arrow_tree.hpp"
#include "estimation/smoothing/border_status.hpp"
#include "estimation/smoothing/chain_graph.hpp"

namespace limpet {

/// Linearises a term on border variables alone at the estimates `border` (three per slot); its
/// residual is where the changes from `origin` are zero.
void LinearizeBorderTerm(const Term& term, const std::vector<double>& border,
                         const ArrowOrigin& origin, LinearTerm& linear);

/// What all full leaves, the border's own terms and the joint prior say of the last anchor and the
/// border variables that are not closed.
struct BorderInformation {
  ArrowMessage message;    ///< over (anchor, `slots`), as changes from the origin
  std::vector<int> slots;  ///< those that leaves touch come first
};
[[nodiscard]] BorderInformation CollectBorderInformation(const ChainGraph& graph,
                                                         const ArrowTree& tree,
                                                         const std::vector<BorderStatus>& status,
                                                         const std::vector<double>& border);

}  // namespace limpet
