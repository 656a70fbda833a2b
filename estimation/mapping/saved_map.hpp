// SPDX-License-Identifier: MIT
// The map as a session's files hold it: tile by tile (`map/<north>_<east>.ot.gz`), or, as older
// sessions have it, as a whole (`map.ot`). File name -> bytes; errors begin with the file's name.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "estimation/mapping/map_export.hpp"
#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/core/expected.hpp"
#include "limpet/topics/map_tile.hpp"

namespace limpet {

using MapFiles = std::map<std::string, std::string>;

/// All of the map; empty, with voxels of a default size, if there are no files.
[[nodiscard]] Expected<SemanticOctree> OctreeOf(const MapFiles& files);
/// What of it is occupied, one file after another, without a tree of it all.
[[nodiscard]] Expected<OccupiedMap> OccupiedOf(const MapFiles& files);
/// A map that was saved as a whole, in tiles. The error says what is wrong with it.
[[nodiscard]] Expected<std::vector<MapTile>> TilesOf(const std::string& octree);

}  // namespace limpet
