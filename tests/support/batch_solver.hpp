// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/smoothing/chain_graph.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// Levenberg-Marquardt over the whole graph with a sparse Cholesky in natural order (poses in time,
/// landmarks last). The oracle of the incremental smoother and its fallback: same terms, other
/// arithmetic. Moves the graph's variables to the optimum.
[[nodiscard]] SolveReport SolveBatch(ChainGraph& graph, int max_iterations = 50);

}  // namespace limpet
