// SPDX-License-Identifier: MIT
#include "estimation/mapping/evidence_tile.hpp"

#include <algorithm>
#include <cstddef>

namespace limpet {
namespace {

constexpr int kLowBits = 16;

/// Counts by `delta`, one or its negative; returns what the two bytes could not hold of it.
std::uint32_t CountLow(std::uint16_t& low, std::uint32_t delta) {
  const std::uint16_t before = low;
  low = static_cast<std::uint16_t>(before + delta);
  const bool is_up = delta == 1;
  const bool has_wrapped = is_up ? low < before : low > before;
  return has_wrapped ? delta : 0;
}

}  // namespace

std::size_t EvidenceTile::PlaceInBrick(const VoxelIndex& at) {
  constexpr std::int32_t kInside = kEdge - 1;
  return static_cast<std::size_t>((at[0] & kInside) | (at[1] & kInside) << kBits |
                                  (at[2] & kInside) << (2 * kBits));
}

const EvidenceTile::Brick* EvidenceTile::Find(const BrickKey& key) const {
  const Column& column = columns_[ColumnOf(key)];
  // Unsigned, what lies above the top is far below the last.
  const auto layer = static_cast<std::uint32_t>(key[2] - column.top);
  return layer < column.bricks.size() ? column.bricks[layer].get() : nullptr;
}

EvidenceTile::Brick& EvidenceTile::Make(const BrickKey& key) {
  Column& column = columns_[ColumnOf(key)];
  std::vector<std::unique_ptr<Brick>>& bricks = column.bricks;
  const std::size_t before = bricks.size();
  if (bricks.empty()) column.top = key[2];
  if (const std::int32_t above = column.top - key[2]; above > 0) {
    bricks.resize(before + static_cast<std::size_t>(above));
    std::rotate(bricks.begin(), bricks.begin() + static_cast<std::ptrdiff_t>(before), bricks.end());
    column.top = key[2];
  }
  const auto layer = static_cast<std::size_t>(key[2] - column.top);
  if (layer >= bricks.size()) bricks.resize(layer + 1);
  layers_ += bricks.size() - before;
  if (bricks[layer] == nullptr) {
    bricks[layer] = std::make_unique<Brick>();
    ++bricks_;
  }
  return *bricks[layer];
}

bool EvidenceTile::Count(BeamWalk& walk, std::uint32_t delta) {
  BrickKey key = BrickOf(walk.at());
  Brick* brick = &Make(key);
  while (true) {
    const VoxelIndex& at = walk.at();
    if (const BrickKey here = BrickOf(at); here != key) {
      if (!IsMine(here)) return false;
      key = here;
      brick = &Make(key);
    }
    const std::size_t voxel = PlaceInBrick(at);
    LowCounts& counts = brick->voxels[voxel];
    const bool is_end = walk.HasArrived();
    const std::uint32_t carried = CountLow(is_end ? counts.hits : counts.misses, delta);
    if (carried != 0) {
      Carry(key, *brick, voxel,
            is_end ? VoxelCounts{.hits = carried} : VoxelCounts{.misses = carried});
    }
    if (is_end) return true;
    walk.Step();
  }
}

void EvidenceTile::Carry(const BrickKey& key, Brick& brick, std::size_t voxel,
                         const VoxelCounts& carried) {
  brick.has_carries = true;
  VoxelCounts& carry = carries_[key][voxel];
  carry.hits += carried.hits;
  carry.misses += carried.misses;
}

VoxelCounts EvidenceTile::CountsOf(const BrickKey& key, const Brick& brick,
                                   std::size_t voxel) const {
  const LowCounts& low = brick.voxels[voxel];
  VoxelCounts counts{.hits = low.hits, .misses = low.misses};
  if (!brick.has_carries) return counts;
  const auto& carries = carries_.at(key);
  if (const auto carry = carries.find(voxel); carry != carries.end()) {
    counts.hits += carry->second.hits << kLowBits;
    counts.misses += carry->second.misses << kLowBits;
  }
  return counts;
}

VoxelCounts EvidenceTile::At(const VoxelKey& key) const {
  const VoxelIndex at = IndexOf(key);
  const BrickKey brick_key = BrickOf(at);
  const Brick* brick = Find(brick_key);
  return brick == nullptr ? VoxelCounts{} : CountsOf(brick_key, *brick, PlaceInBrick(at));
}

void EvidenceTile::Visit(const BrickKey& key, const Brick& brick, const VoxelVisitor& visit) const {
  constexpr std::size_t kEdgeVoxels = kEdge;
  for (std::size_t voxel = 0; voxel < brick.voxels.size(); ++voxel) {
    const VoxelCounts counts = CountsOf(key, brick, voxel);
    if (!counts.is_known()) continue;
    const std::array<std::size_t, 3> in{voxel % kEdgeVoxels, voxel / kEdgeVoxels % kEdgeVoxels,
                                        voxel / kEdgeVoxels / kEdgeVoxels};
    VoxelKey at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at[axis] = std::int64_t{key[axis]} * kEdge + static_cast<std::int64_t>(in[axis]);
    }
    visit(at, counts);
  }
}

void EvidenceTile::ForEachKnown(const VoxelVisitor& visit) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    const auto north = static_cast<std::int32_t>(i / kBricks);
    const auto east = static_cast<std::int32_t>(i % kBricks);
    BrickKey key{key_.north * kBricks + north, key_.east * kBricks + east, column.top};
    for (const std::unique_ptr<Brick>& brick : column.bricks) {
      if (brick != nullptr) Visit(key, *brick, visit);
      ++key[2];
    }
  }
}

}  // namespace limpet
