// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

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
/// of which large bricks would hold little. A column of bricks is an array from its lowest to its
/// highest, so a beam finds its next brick without a search.
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
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(*this) + bricks_ * kBrickBytes + layers_ * sizeof(std::unique_ptr<Brick>);
  }

 private:
  static constexpr int kBits = 2;  ///< of a voxel's index in its brick, per axis
  static constexpr int kEdge = 1 << kBits;
  static constexpr int kBrickBits = kTileBits - kBits;  ///< of a brick's index in its tile
  static constexpr int kBricks = 1 << kBrickBits;
  using BrickKey = std::array<std::int32_t, 3>;
  /// What two bytes hold of a voxel's counts. A voxel beside a vehicle that waits has more.
  struct LowCounts {
    std::uint16_t hits = 0, misses = 0;
  };
  struct Brick {
    std::array<LowCounts, std::size_t{kEdge} * kEdge * kEdge> voxels{};
    bool has_carries = false;  ///< now or formerly
  };
  /// Bricks above each other.
  struct Column {
    std::int32_t top = 0;  ///< index of the first, down
    std::vector<std::unique_ptr<Brick>> bricks;
  };
  static constexpr std::size_t kBrickBytes = sizeof(Brick) + 16;  ///< with what the heap has of it

  [[nodiscard]] static BrickKey BrickOf(const VoxelIndex& at) {
    return {at[0] >> kBits, at[1] >> kBits, at[2] >> kBits};
  }
  [[nodiscard]] static std::size_t PlaceInBrick(const VoxelIndex& at);
  [[nodiscard]] bool IsMine(const BrickKey& key) const {
    return key[0] >> kBrickBits == key_.north && key[1] >> kBrickBits == key_.east;
  }
  [[nodiscard]] static std::size_t ColumnOf(const BrickKey& key) {
    constexpr std::int32_t kInside = kBricks - 1;
    return static_cast<std::size_t>((key[0] & kInside) << kBrickBits | (key[1] & kInside));
  }
  /// nullptr where no beam has been.
  [[nodiscard]] const Brick* Find(const BrickKey& key) const;
  [[nodiscard]] Brick& Make(const BrickKey& key);
  void Carry(const BrickKey& key, Brick& brick, std::size_t voxel, const VoxelCounts& carried);
  [[nodiscard]] VoxelCounts CountsOf(const BrickKey& key, const Brick& brick,
                                     std::size_t voxel) const;
  void Visit(const BrickKey& key, const Brick& brick, const VoxelVisitor& visit) const;

  TileKey key_;
  std::array<Column, std::size_t{kBricks} * kBricks> columns_;
  std::size_t bricks_ = 0, layers_ = 0;  ///< of all columns, the latter with those without a brick
  /// Carries of voxels, by their number in the brick: times 65 536 to be added to what it holds of
  /// them.
  std::map<BrickKey, std::map<std::size_t, VoxelCounts>> carries_;
};

}  // namespace limpet
