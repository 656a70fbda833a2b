// SPDX-License-Identifier: MIT
// The semantic map for other programs. Viewers take east, north, up; tables keep NED.
#pragma once

#include <string>
#include <vector>

#include "estimation/mapping/semantic_octree.hpp"

namespace limpet {

/// Red, green, blue of a voxel; colour-blind safe (Okabe and Ito).
struct VoxelColor {
  std::uint8_t red = 0, green = 0, blue = 0;
};
[[nodiscard]] VoxelColor ColorOf(const VoxelBelief& belief);

/// Occupied leaves cut to the tree's resolution, so that every voxel stands for itself.
[[nodiscard]] std::vector<Voxel> OccupiedVoxels(const SemanticOctree& octree);

/// Occupied voxels, one per line: north_m,east_m,down_m,size_m,p_occupied,p_object,p_exists,label.
[[nodiscard]] std::string ToCsv(const SemanticOctree& octree);
/// Occupied voxels as coloured points, ASCII PLY; x east, y north, z up.
[[nodiscard]] std::string ToPly(const SemanticOctree& octree);
/// Occupied voxels as a ColorOcTree `.ot`, which octovis opens; x east, y north, z up.
[[nodiscard]] std::string ToColorOctree(const SemanticOctree& octree);

}  // namespace limpet
