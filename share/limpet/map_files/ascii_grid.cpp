// SPDX-License-Identifier: MIT
#include "limpet/map_files/ascii_grid.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace limpet {

std::string ToAsciiGrid(const DepthGrid& grid, std::span<const float> values) {
  std::string text = fmt::format(
      "ncols {}\nnrows {}\nxllcorner {:.3f}\nyllcorner {:.3f}\ncellsize {:g}\n"
      "NODATA_value -9999\n",
      grid.frame.columns, grid.frame.rows, grid.frame.east_min, grid.frame.north_min,
      grid.frame.cell_m);
  for (int row = grid.frame.rows - 1; row >= 0; --row) {
    for (int column = 0; column < grid.frame.columns; ++column) {
      const float value = values[grid.Index(row, column)];
      text += column > 0 ? " " : "";
      if (std::isnan(value)) {
        text += "-9999";
      } else {
        fmt::format_to(std::back_inserter(text), "{:.3f}", value);
      }
    }
    text += "\n";
  }
  return text;
}

}  // namespace limpet
