// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/mapping/depth_map.hpp"
#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/core/expected.hpp"
#include "limpet/session/session_memory.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Depth of the seabed by columns of a session's map.
struct DepthGrid {
  GridFrame frame;
  std::vector<float> down_m;   ///< not a number where no beam ended
  std::vector<float> sigma_m;  ///< of those, beside what the whole session is off by
  double zero_sigma_m = 0.0;   ///< by how much that may be

  [[nodiscard]] std::size_t Index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool IsKnown(std::size_t cell) const { return !std::isnan(down_m[cell]); }
  /// The cell that holds a place; nothing outside the grid, or where no beam ended.
  [[nodiscard]] std::optional<std::size_t> At(const Eigen::Vector2d& p_W) const;
};

[[nodiscard]] DepthGrid DepthGridOf(const DepthMap& depths);
/// Of a session that kept no depths: of each column of voxels on the ground the depth where most
/// beams ended; its sigma is the voxel's height and the beams' spread. Empty for a map without any.
[[nodiscard]] DepthGrid DepthGridOf(const SemanticOctree& octree);
/// The session's depths as finely as it kept them. The error names the file that is damaged.
[[nodiscard]] Expected<DepthGrid> DepthGridOf(const SessionMemory& memory);

}  // namespace limpet
