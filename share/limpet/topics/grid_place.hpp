// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "limpet/topics/mapping.hpp"

namespace limpet {

/// A cell of a survey grid; row 0 and column 0 are the most southern and the most western ones.
struct GridPlace {
  int row = 0, column = 0;
};

/// The cell that holds a place in W [m]; its south and west edges belong to it, its others do not.
/// Nothing outside the grid, in a grid without cells, or for what is no number.
[[nodiscard]] inline std::optional<GridPlace> GridPlaceOf(const GridFrame& frame,
                                                          const Eigen::Vector2d& p_W) {
  const double row = std::floor((p_W.x() - frame.north_min) / frame.cell_m);
  const double column = std::floor((p_W.y() - frame.east_min) / frame.cell_m);
  const bool is_inside = row >= 0.0 && row < frame.rows && column >= 0.0 && column < frame.columns;
  if (!is_inside) return std::nullopt;
  return GridPlace{.row = static_cast<int>(row), .column = static_cast<int>(column)};
}

}  // namespace limpet
