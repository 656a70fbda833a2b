// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/dubins_path.hpp"
#include "limpet/planning/pass.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// A short way through all stops from `start`: nearest neighbour, improved by moving stops and
/// turning runs around, each time with the best passes (a travelling salesman of Dubins motions).
/// The motions between stops stay inside the region where any word does. Deterministic; its work
/// grows with the square of the number of passes.
struct PassTour {
  DubinsPath path;
  std::vector<std::size_t> order;   ///< of the stops
  std::vector<std::size_t> passes;  ///< of each of these the one flown
  std::vector<double> reached;      ///< path length at the end of each stop's pass, in order
};
[[nodiscard]] PassTour PlanPassTour(const Pose2& start, const std::vector<Stop>& stops,
                                    const Region& region, Meters turn_radius);

}  // namespace limpet
