// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/planning/dubins_path.hpp"
#include "limpet/shapes/shape.hpp"

namespace limpet {

/// The corners of a path, for those who know no arcs: chords that leave them by at most `sagitta`
/// [m].
[[nodiscard]] std::vector<MapPoint> MapPointsOf(const DubinsPath& path, double sagitta);

}  // namespace limpet
