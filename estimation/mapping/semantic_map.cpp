// SPDX-License-Identifier: MIT
#include "estimation/mapping/semantic_map.hpp"

#include <utility>

namespace limpet {

SemanticMap::SemanticMap(Meters resolution, const DvlBeams& dvl, std::size_t most_held)
    : beams_(resolution, dvl, most_held), former_(resolution.value()) {}

void SemanticMap::Paint(const VoxelKey& key, const VoxelBelief& belief) {
  const TileKey tile = TileOf(key);
  painted_[tile][key] = belief;
  changed_.insert(tile);
}

void SemanticMap::Unpaint(const VoxelKey& key) {
  const auto tile = painted_.find(TileOf(key));
  if (tile == painted_.end() || tile->second.erase(key) == 0) return;
  changed_.insert(tile->first);
  if (tile->second.empty()) painted_.erase(tile);
}

std::optional<Error> SemanticMap::AddFormer(const MapTile& tile) {
  if (std::optional<Error> error = former_.Add(tile)) return error;
  const std::vector<TileKey> reached = former_.TilesOf(tile.key);
  changed_.insert(reached.begin(), reached.end());
  return std::nullopt;
}

void SemanticMap::SetFormerOffset(const FrameOffset& offset) {
  const std::vector<TileKey> before = former_.Tiles();
  if (!former_.SetOffset(offset)) return;
  const std::vector<TileKey> after = former_.Tiles();
  changed_.insert(before.begin(), before.end());
  changed_.insert(after.begin(), after.end());
}

std::optional<VoxelBelief> SemanticMap::At(const VoxelKey& key) const {
  const auto tile = painted_.find(TileOf(key));
  if (tile != painted_.end()) {
    const auto painted = tile->second.find(key);
    if (painted != tile->second.end()) return painted->second;
  }
  const VoxelCounts counts = beams_.At(key);
  const std::optional<float> former = former_.At(key);
  if (!former && !counts.is_known()) return std::nullopt;
  return VoxelBelief{.occupied = OccupiedLogOdds(counts, former.value_or(0.0F))};
}

bool SemanticMap::IsClear(const VoxelKey& key) const {
  if (const auto tile = painted_.find(TileOf(key)); tile != painted_.end()) {
    const auto painted = tile->second.find(key);
    if (painted != tile->second.end() && painted->second.occupied > 0.0F) return false;
  }
  return OccupiedLogOdds(beams_.At(key)) <= 0.0F;
}

std::vector<TileKey> SemanticMap::TakeChanged() {
  beams_.SettleAll();
  const std::vector<TileKey> by_beams = beams_.TakeChanged();
  changed_.insert(by_beams.begin(), by_beams.end());
  const std::set<TileKey> changed = std::exchange(changed_, {});
  return {changed.begin(), changed.end()};
}

std::vector<TileKey> SemanticMap::Tiles() const {
  const std::vector<TileKey> of_beams = beams_.Tiles(), of_former = former_.Tiles();
  std::set<TileKey> tiles(of_beams.begin(), of_beams.end());
  tiles.insert(of_former.begin(), of_former.end());
  for (const auto& [tile, voxels] : painted_) {
    tiles.insert(tile);
  }
  return {tiles.begin(), tiles.end()};
}

SemanticOctree SemanticMap::OctreeOf(const TileKey& tile, const GroundOdds& object) const {
  SemanticOctree octree{Meters(resolution())};
  const auto set = [&](const VoxelKey& key, VoxelBelief belief) {
    const bool is_ground = belief.label == VoxelLabel::kGround && belief.occupied > 0.0F;
    if (is_ground && object) belief.object = object(key);
    octree.Set(CentreOf(key, resolution()), belief);
  };
  const std::vector<FormerGround::Laid>& former = former_.LaidIn(tile);
  for (const FormerGround::Laid& laid : former) {
    set({laid.key[0], laid.key[1], laid.key[2]}, {.occupied = laid.occupied});
  }
  const bool has_former = !former.empty();
  beams_.ForEachKnown(tile, [&](const VoxelKey& key, const VoxelCounts& counts) {
    const float before = has_former ? former_.At(key).value_or(0.0F) : 0.0F;
    set(key, {.occupied = OccupiedLogOdds(counts, before)});
  });
  if (const auto painted = painted_.find(tile); painted != painted_.end()) {
    for (const auto& [key, belief] : painted->second) {
      set(key, belief);
    }
  }
  return octree;
}

}  // namespace limpet
