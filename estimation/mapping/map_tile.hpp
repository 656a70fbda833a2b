// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "estimation/mapping/beam_walk.hpp"
#include "estimation/mapping/voxel_cluster.hpp"
#include "limpet/topics/map_tile.hpp"

namespace limpet {

/// Of a voxel's index along north and east, what says where it lies in its tile. Octrees have such
/// squares of 64 x 64 voxels as columns of nodes, so no node is of two tiles.
inline constexpr int kTileBits = 6;
inline constexpr int kTileVoxels = 1 << kTileBits;

/// A voxel's index as octrees and bricks keep it: up to 32 768 either way.
[[nodiscard]] inline VoxelIndex IndexOf(const VoxelKey& key) {
  return {static_cast<std::int32_t>(key[0]), static_cast<std::int32_t>(key[1]),
          static_cast<std::int32_t>(key[2])};
}

[[nodiscard]] inline TileKey TileOf(const VoxelKey& key) {
  return {.north = static_cast<std::int32_t>(key[0] >> kTileBits),
          .east = static_cast<std::int32_t>(key[1] >> kTileBits)};
}

}  // namespace limpet
