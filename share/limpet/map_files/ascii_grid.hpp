// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "limpet/map_files/depth_grid.hpp"

namespace limpet {

/// One number per cell of `grid` as an Esri ASCII grid: x east, y north in the session's frame,
/// rows from the north, -9999 where nothing is known.
[[nodiscard]] std::string ToAsciiGrid(const DepthGrid& grid, std::span<const float> values);

}  // namespace limpet
