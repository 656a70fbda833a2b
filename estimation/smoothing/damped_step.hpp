// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/smoothing/chain_graph.hpp"

namespace limpet {

/// Values of all variables of a graph.
struct ChainValues {
  std::vector<NavVector> poses;
  std::vector<Eigen::Vector3d> border;  ///< by slot
};

[[nodiscard]] ChainValues ValuesOf(const ChainGraph& graph);
void SetValues(const ChainValues& values, ChainGraph& graph);

struct DampedStep {
  double cost = 0.0;   ///< where it ended
  double share = 0.0;  ///< of the way that was taken: 1, halves of it down to a thousandth, or 0
};

/// Moves the graph's variables from `from` towards `to` as far as the cost does not rise above
/// `cost_before`.
DampedStep StepTowards(const ChainValues& from, const ChainValues& to, double cost_before,
                       ChainGraph& graph);

}  // namespace limpet
