// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/planning/ground.hpp"

namespace limpet {

/// Cells of one tile that have not been seen up to the top of the band.
struct Patch {
  double north = 0.0, east = 0.0;  ///< centre of its bounding box along its axes [m]
  double axis_yaw = 0.0;           ///< of its long axis [rad]
  double length = 0.0;             ///< along the long axis [m]
  double width = 0.0;              ///< across it [m]
  double unseen_m2 = 0.0;          ///< area not seen up to the top
  double missing_m2 = 0.0;         ///< area unseen, weighted mean over the layers
};

/// The unseen patches of the ground, cut into tiles of `tile_m`, most missing first. Tiles keep
/// patches straight: one pass along the axis shows a patch.
[[nodiscard]] std::vector<Patch> UnseenPatches(const Ground& ground, double tile_m);

}  // namespace limpet
