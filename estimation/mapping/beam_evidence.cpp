// SPDX-License-Identifier: MIT
#include "estimation/mapping/beam_evidence.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/mapping/beam_walk.hpp"

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

float OccupiedLogOdds(const VoxelCounts& counts, float before) {
  constexpr double kHit = 0.8472978603872034, kMiss = -0.4054651081081643;  // ln p / (1 - p)
  constexpr double kLeast = -2.0, kMost = 3.5;
  return static_cast<float>(std::clamp(
      static_cast<double>(before) + kHit * counts.hits + kMiss * counts.misses, kLeast, kMost));
}

bool BeamEvidence::Holds(const Eigen::Vector3d& p_W) const {
  constexpr double kMostVoxels = 32767.0;
  return (p_W.array().abs() < kMostVoxels * resolution_).all();  // false for what is no number
}

std::size_t BeamEvidence::BrickHash::operator()(const BrickKey& key) const {
  constexpr std::uint64_t kSpread = 0x9e3779b97f4a7c15ULL;
  std::uint64_t hash = 0;
  for (const std::int32_t index : key) {
    hash = (hash ^ static_cast<std::uint32_t>(index)) * kSpread;
    hash ^= hash >> 29U;
  }
  return static_cast<std::size_t>(hash);
}

BeamEvidence::Brick& BeamEvidence::ChangedBrick(const BrickKey& key) {
  Brick& brick = bricks_[key];
  if (!brick.is_changed) {
    brick.is_changed = true;
    changed_.push_back(key);
  }
  return brick;
}

void BeamEvidence::Count(const Eigen::Vector3d& origin_W, const Eigen::Vector3d& end_W,
                         std::uint32_t delta) {
  constexpr std::int32_t kInside = kEdge - 1;
  BeamWalk walk(origin_W / resolution_, end_W / resolution_);
  const auto brick_of = [](const VoxelIndex& at) {
    return BrickKey{at[0] >> kBits, at[1] >> kBits, at[2] >> kBits};
  };
  BrickKey key = brick_of(walk.at());
  Brick* brick = &ChangedBrick(key);
  while (true) {
    const VoxelIndex& at = walk.at();
    if (const BrickKey here = brick_of(at); here != key) {
      key = here;
      brick = &ChangedBrick(key);
    }
    const auto voxel = static_cast<std::size_t>((at[0] & kInside) | (at[1] & kInside) << kBits |
                                                (at[2] & kInside) << (2 * kBits));
    LowCounts& counts = brick->voxels[voxel];
    const bool is_end = walk.HasArrived();
    const std::uint32_t carried = CountLow(is_end ? counts.hits : counts.misses, delta);
    if (carried != 0) {
      Carry(key, *brick, voxel,
            is_end ? VoxelCounts{.hits = carried} : VoxelCounts{.misses = carried});
    }
    if (is_end) return;
    walk.Step();
  }
}

void BeamEvidence::Carry(const BrickKey& key, Brick& brick, std::size_t voxel,
                         const VoxelCounts& carried) {
  brick.has_carries = true;
  VoxelCounts& carry = carries_[key][voxel];
  carry.hits += carried.hits;
  carry.misses += carried.misses;
}

VoxelCounts BeamEvidence::CountsOf(const BrickKey& key, const Brick& brick,
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

VoxelCounts BeamEvidence::At(const VoxelKey& key) const {
  const auto part = [&key](std::size_t axis) { return static_cast<std::int32_t>(key[axis]); };
  const auto found = bricks_.find({part(0) >> kBits, part(1) >> kBits, part(2) >> kBits});
  if (found == bricks_.end()) return {};
  constexpr std::int32_t kInside = kEdge - 1;
  return CountsOf(found->first, found->second,
                  static_cast<std::size_t>((part(0) & kInside) | (part(1) & kInside) << kBits |
                                           (part(2) & kInside) << (2 * kBits)));
}

void BeamEvidence::Visit(const BrickKey& key, const Brick& brick, const VoxelVisitor& visit) const {
  constexpr std::size_t kEdgeVoxels = kEdge;
  for (std::size_t voxel = 0; voxel < brick.voxels.size(); ++voxel) {
    const std::array<std::size_t, 3> in{voxel % kEdgeVoxels, voxel / kEdgeVoxels % kEdgeVoxels,
                                        voxel / kEdgeVoxels / kEdgeVoxels};
    VoxelKey at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at[axis] = std::int64_t{key[axis]} * kEdge + static_cast<std::int64_t>(in[axis]);
    }
    visit(at, CountsOf(key, brick, voxel));
  }
}

void BeamEvidence::TakeChanged(const VoxelVisitor& visit) {
  for (const BrickKey& key : changed_) {
    Brick& brick = bricks_[key];
    brick.is_changed = false;
    Visit(key, brick, visit);
  }
  changed_.clear();
}

void BeamEvidence::ForEachKnown(const VoxelVisitor& visit) const {
  for (const auto& [key, brick] : bricks_) {
    Visit(key, brick, [&visit](const VoxelKey& at, const VoxelCounts& counts) {
      if (counts.is_known()) visit(at, counts);
    });
  }
}

}  // namespace limpet
