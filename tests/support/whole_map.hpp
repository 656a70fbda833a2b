// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/mapping/semantic_map.hpp"

namespace limpet {

/// All of a map as one octree, equal voxels side by side merged.
inline SemanticOctree WholeOctree(SemanticMap& map, const SemanticMap::GroundOdds& object = {}) {
  static_cast<void>(map.TakeChanged());  // shifts that still wait
  SemanticOctree whole{Meters(map.resolution())};
  for (const TileKey& tile : map.Tiles()) {
    map.OctreeOf(tile, object).ForEachLeaf([&](const Voxel& leaf) { whole.AddLeaf(leaf); });
  }
  whole.Merge();
  return whole;
}

}  // namespace limpet
