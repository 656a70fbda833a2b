// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/survey/simple_polygon.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// Cells that a grid may have: 1250 m by 1250 m at 0.25 m.
inline constexpr double kMostGridCells = 25e6;

/// Cell of planners' mirrors [m]: they take the changes of grids with no other.
inline constexpr double kGridCell_m = 0.25;

/// Why no grid of `cell_m` can be made of what SURVEY_AREA says, with the values; nothing if one
/// can. Whoever takes an area from outside asks first.
[[nodiscard]] std::optional<std::string> ProblemOf(const SurveyArea& area,
                                                   double cell_m = kGridCell_m);

/// The frame of a grid over `area` or the box around it; cells at the north and east edge may reach
/// beyond it by less than a cell.
/// REQUIRES: no ProblemOf(area, cell_m).
[[nodiscard]] GridFrame FrameOf(const SurveyArea& area, double cell_m);

/// The place that stands for a cell: jittered inside it by a fixed hash, because a planner that
/// sees regular cell centres learns to leave gaps between them.
[[nodiscard]] PlanePoint SamplePoint(const GridFrame& frame, int row, int column);

}  // namespace limpet
