// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <unordered_map>

#include "estimation/mapping/beam_walk.hpp"
#include "estimation/mapping/map_tile.hpp"

namespace limpet {

/// How many beams ended in a voxel, and how many went through it.
struct VoxelCounts {
  std::uint32_t hits = 0;
  std::uint32_t misses = 0;
  [[nodiscard]] bool is_known() const { return hits != 0 || misses != 0; }
  bool operator==(const VoxelCounts&) const = default;
};

/// A tile's voxel counts, in bricks of 4 x 4 x 4 voxels: beams of a vehicle under way fill sheets,
/// of which large bricks would hold little.
class EvidenceTile {
 public:
  using VoxelVisitor = std::function<void(const VoxelKey&, const VoxelCounts&)>;

  explicit EvidenceTile(const TileKey& key) : key_(key) {}

  /// Counts a beam's voxels from where its walk is, which is in this tile, until it has left the
  /// tile or arrived. True if it has arrived. `delta` is one, or its negative modulo 2^32.
  bool Count(BeamWalk& walk, std::uint32_t delta);
  /// Zeros where no beam has been. REQUIRES: a voxel of this tile.
  [[nodiscard]] VoxelCounts At(const VoxelKey& key) const;
  /// All voxels that beams have been in, in no order.
  void ForEachKnown(const VoxelVisitor& visit) const;
  /// What it takes of memory, about.
  [[nodiscard]] std::size_t bytes() const { return bricks_.size() * kBrickBytes; }

 private:
  static constexpr int kBits = 2;  ///< of a voxel's index in its brick, per axis
  static constexpr int kEdge = 1 << kBits;
  using BrickKey = std::array<std::int32_t, 3>;
  struct BrickHash {
    std::size_t operator()(const BrickKey& key) const;
  };
  /// What two bytes hold of a voxel's counts. A voxel beside a vehicle that waits has more.
  struct LowCounts {
    std::uint16_t hits = 0, misses = 0;
  };
  struct Brick {
    std::array<LowCounts, std::size_t{kEdge} * kEdge * kEdge> voxels{};
    bool has_carries = false;  ///< now or formerly
  };
  /// With its key and what the hash table has of it.
  static constexpr std::size_t kBrickBytes = sizeof(Brick) + 48;

  [[nodiscard]] static BrickKey BrickOf(const VoxelIndex& at) {
    return {at[0] >> kBits, at[1] >> kBits, at[2] >> kBits};
  }
  [[nodiscard]] static std::size_t PlaceInBrick(const VoxelIndex& at);
  [[nodiscard]] bool IsMine(const BrickKey& key) const {
    constexpr int kBrickBits = kTileBits - kBits;
    return key[0] >> kBrickBits == key_.north && key[1] >> kBrickBits == key_.east;
  }
  void Carry(const BrickKey& key, Brick& brick, std::size_t voxel, const VoxelCounts& carried);
  [[nodiscard]] VoxelCounts CountsOf(const BrickKey& key, const Brick& brick,
                                     std::size_t voxel) const;
  void Visit(const BrickKey& key, const Brick& brick, const VoxelVisitor& visit) const;

  TileKey key_;
  std::unordered_map<BrickKey, Brick, BrickHash> bricks_;
  /// Of voxels by their number in the brick: times 65 536 to what the brick holds of them.
  std::unordered_map<BrickKey, std::map<std::size_t, VoxelCounts>, BrickHash> carries_;
};

}  // namespace limpet
