// SPDX-License-Identifier: MIT
#include "apps/pMap/map_teller.hpp"

#include "limpet/session/checksum.hpp"

namespace limpet {

void MapTeller::Begin() {
  for (const TileKey& tile : map_.TakeChanged()) {
    due_.insert(tile);
  }
  due_.merge(looks_.TakeChanged());
}

void MapTeller::BeginAnew() {
  Begin();
  for (const TileKey& tile : map_.Tiles()) {
    due_.insert(tile);
  }
  checksums_.clear();
}

std::optional<MapTile> MapTeller::Next(int& most) {
  while (!due_.empty() && most > 0) {
    --most;
    const TileKey key = due_.extract(due_.begin()).value();
    const SemanticOctree octree =
        map_.OctreeOf(key, [this](const VoxelKey& voxel) { return looks_.LogOdds(voxel); });
    if (octree.nodes() == 0) {
      if (!table_.Has(key)) continue;
      checksums_.erase(key);
      table_.Put({.key = key, .packed = {}});
      return MapTile{.key = key, .packed = {}};
    }
    const std::string bytes = octree.Serialize();
    std::string& told = checksums_[key];
    std::string checksum = ChecksumOf(bytes);
    if (told == checksum) continue;
    told = std::move(checksum);
    MapTile tile = MapTile::Of(key, bytes);
    table_.Put(tile);
    return tile;
  }
  return std::nullopt;
}

}  // namespace limpet
