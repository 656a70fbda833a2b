// SPDX-License-Identifier: MIT
// The semantic map for other programs. Viewers take east, north, up; tables keep NED.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/core/expected.hpp"

namespace limpet {

/// Red, green, blue of a voxel; colour-blind safe (Okabe and Ito).
struct VoxelColor {
  std::uint8_t red = 0, green = 0, blue = 0;
};
[[nodiscard]] VoxelColor ColorOf(const VoxelBelief& belief);

/// What of a map is occupied.
struct OccupiedMap {
  double resolution = 0.0;    ///< edge of every voxel [m]
  std::vector<Voxel> voxels;  ///< leaves cut to that, so that every voxel stands for itself
};
[[nodiscard]] OccupiedMap OccupiedOf(const SemanticOctree& octree);
/// Occupied voxels of a map as it is saved (SemanticOctree::Serialize), which is not built for it.
[[nodiscard]] Expected<OccupiedMap> OccupiedOfStream(std::string_view bytes);

/// One voxel per line: north_m,east_m,down_m,size_m,p_occupied,p_object,p_exists,label.
[[nodiscard]] std::string ToCsv(const OccupiedMap& map);
/// Coloured points, ASCII PLY; x east, y north, z up.
[[nodiscard]] std::string ToPly(const OccupiedMap& map);
/// A ColorOcTree `.ot`, which octovis opens; x east, y north, z up.
[[nodiscard]] std::string ToColorOctree(const OccupiedMap& map);

}  // namespace limpet
