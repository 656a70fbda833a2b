// SPDX-License-Identifier: MIT
#include "estimation/mapping/beam_evidence.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/mapping/cell_hash.hpp"

namespace limpet {
namespace {

TileKey TileAt(const VoxelIndex& at) {
  return {.north = at[0] >> kTileBits, .east = at[1] >> kTileBits};
}

/// Steps a walk through a tile without counting. True if it has arrived there.
bool PassBy(const TileKey& tile, BeamWalk& walk) {
  while (TileAt(walk.at()) == tile) {
    if (walk.HasArrived()) return true;
    walk.Step();
  }
  return false;
}

}  // namespace

float OccupiedLogOdds(const VoxelCounts& counts, float before) {
  constexpr double kHit = 0.8472978603872034, kMiss = -0.4054651081081643;  // ln p / (1 - p)
  constexpr double kLeast = -2.0, kMost = 3.5;
  return static_cast<float>(std::clamp(
      static_cast<double>(before) + kHit * counts.hits + kMiss * counts.misses, kLeast, kMost));
}

std::size_t BeamEvidence::TileHash::operator()(const TileKey& key) const {
  return CellHash(key.north, key.east);
}

bool BeamEvidence::Holds(const Eigen::Vector3d& p_W) const {
  constexpr double kMostVoxels = 32767.0;
  return (p_W.array().abs() < kMostVoxels * resolution_).all();  // false for what is no number
}

bool BeamEvidence::CountIn(EvidenceTile& held, BeamWalk& walk, std::uint32_t delta) {
  const std::size_t before = held.bytes();
  const bool has_arrived = held.Count(walk, delta);
  held_bytes_ += held.bytes() - before;
  return has_arrived;
}

void BeamEvidence::Count(const Eigen::Vector3d& origin_W, const Eigen::Vector3d& end_W,
                         std::uint32_t delta) {
  BeamWalk walk = WalkOf(origin_W, end_W);
  bool has_arrived = false;
  while (!has_arrived) {
    const TileKey key = TileAt(walk.at());
    Tile* tile = Find(key);
    if (tile == nullptr) {
      tile = (tiles_[key] = std::make_unique<Tile>()).get();
      tile->held = std::make_unique<EvidenceTile>(key);
      held_bytes_ += tile->held->bytes();
    }
    tile->is_changed = true;
    if (tile->held == nullptr) {
      has_arrived = PassBy(key, walk);
    } else {
      tile->used = ++uses_;
      has_arrived = CountIn(*tile->held, walk, delta);
    }
  }
}

void BeamEvidence::DropUnused() {
  while (held_bytes_ > most_held_) {
    Tile* oldest = nullptr;
    for (const auto& [key, tile] : tiles_) {
      const bool is_droppable = tile->held != nullptr && tile->used != uses_;
      if (is_droppable && (oldest == nullptr || tile->used < oldest->used)) oldest = tile.get();
    }
    if (oldest == nullptr) return;
    held_bytes_ -= oldest->held->bytes();
    oldest->held.reset();
  }
}

void BeamEvidence::Hold(const TileKey& tile, const std::function<void(const BeamVisitor&)>& beams) {
  auto held = std::make_unique<EvidenceTile>(tile);
  held_bytes_ += held->bytes();
  beams([&](const Eigen::Vector3d& origin_W, const Eigen::Vector3d& end_W) {
    BeamWalk walk = WalkOf(origin_W, end_W);
    bool has_arrived = false;
    while (!has_arrived) {
      const TileKey here = TileAt(walk.at());
      has_arrived = here == tile ? CountIn(*held, walk, 1) : PassBy(here, walk);
    }
  });
  Tile* kept = Find(tile);
  if (kept == nullptr) kept = (tiles_[tile] = std::make_unique<Tile>()).get();
  if (kept->held != nullptr) held_bytes_ -= kept->held->bytes();
  kept->held = std::move(held);
  kept->used = ++uses_;
  DropUnused();
}

BeamEvidence::Tile* BeamEvidence::Find(const TileKey& tile) const {
  if (recent_ == nullptr || recent_key_ != tile) {
    const auto found = tiles_.find(tile);
    if (found == tiles_.end()) return nullptr;
    recent_ = found->second.get();
    recent_key_ = tile;
  }
  return recent_;
}

const EvidenceTile* BeamEvidence::Use(const TileKey& tile) const {
  Tile* found = Find(tile);
  if (found == nullptr || found->held == nullptr) return nullptr;
  found->used = ++uses_;
  return found->held.get();
}

VoxelCounts BeamEvidence::At(const VoxelKey& key) const {
  const EvidenceTile* tile = Use(TileOf(key));
  return tile == nullptr ? VoxelCounts{} : tile->At(key);
}

void BeamEvidence::ForEachKnown(const TileKey& tile, const VoxelVisitor& visit) const {
  if (const EvidenceTile* held = Use(tile)) held->ForEachKnown(visit);
}

std::vector<TileKey> BeamEvidence::Tiles() const {
  std::vector<TileKey> keys;
  keys.reserve(tiles_.size());
  for (const auto& [key, tile] : tiles_) {
    keys.push_back(key);
  }
  std::ranges::sort(keys);
  return keys;
}

std::vector<TileKey> BeamEvidence::TakeChanged() {
  std::vector<TileKey> changed;
  for (const auto& [key, tile] : tiles_) {
    if (tile->is_changed) changed.push_back(key);
    tile->is_changed = false;
  }
  std::ranges::sort(changed);
  return changed;
}

}  // namespace limpet
