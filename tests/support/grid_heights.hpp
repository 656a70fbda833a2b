// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/survey/survey_grid.hpp"

namespace limpet {

/// Greatest heights seen, row by row, `kNeverSeen` where never seen: as many as the area has cells.
inline std::vector<float> HeightsOf(const SurveyGrid& grid) {
  std::vector<float> heights;
  for (int row = 0; row < grid.frame().rows; ++row) {
    for (int column = 0; column < grid.frame().columns; ++column)
      heights.push_back(grid.LookAt(row, column).height);
  }
  return heights;
}

}  // namespace limpet
