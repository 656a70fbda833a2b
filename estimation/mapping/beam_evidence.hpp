// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "estimation/mapping/voxel_cluster.hpp"

namespace limpet {

/// How many beams ended in a voxel, and how many went through it.
struct VoxelCounts {
  std::uint32_t hits = 0;
  std::uint32_t misses = 0;
  [[nodiscard]] bool is_known() const { return hits != 0 || misses != 0; }
  bool operator==(const VoxelCounts&) const = default;
};

/// Log-odds of being occupied: OctoMap's sensor model (0.7 for a hit, 0.4 for a miss) and its
/// bounds, [0.12, 0.97] in probability, applied to the sums. [Hornung 2013] clamps after each beam
/// instead, so that there the last beams weigh most.
/// `before` is what was known of the voxel without these beams.
[[nodiscard]] float OccupiedLogOdds(const VoxelCounts& counts, float before = 0.0F);

/// What sonar beams say of space, as counts in bricks of 4 x 4 x 4 voxels: beams of a vehicle under
/// way fill sheets, of which large bricks would hold little. Counts are sums, so a beam can be
/// taken back exactly, in any order, and laid elsewhere.
class BeamEvidence {
 public:
  using VoxelVisitor = std::function<void(const VoxelKey&, const VoxelCounts&)>;

  /// `resolution` is a voxel's edge [m].
  explicit BeamEvidence(double resolution) : resolution_(resolution) {}

  /// Whether the point is near enough to the origin: 32 768 voxels along each axis, as in OctoMap.
  [[nodiscard]] bool Holds(const Eigen::Vector3d& p_W) const;
  /// A beam: a miss in each voxel from its origin's up to the end's, which is hit.
  /// REQUIRES: Holds() both points.
  void Add(const Eigen::Vector3d& origin_W, const Eigen::Vector3d& end_W) {
    Count(origin_W, end_W, 1);
  }
  /// Undoes one Add of the very same points.
  void TakeBack(const Eigen::Vector3d& origin_W, const Eigen::Vector3d& end_W) {
    Count(origin_W, end_W, static_cast<std::uint32_t>(-1));
  }

  /// Zeros where no beam has been.
  [[nodiscard]] VoxelCounts At(const VoxelKey& key) const;
  /// All voxels of the bricks that changed since the last call, also those that no beam is left in.
  void TakeChanged(const VoxelVisitor& visit);
  /// All voxels that beams have been in.
  void ForEachKnown(const VoxelVisitor& visit) const;
  [[nodiscard]] double resolution() const { return resolution_; }
  /// Of the bricks themselves.
  [[nodiscard]] std::size_t bytes() const { return bricks_.size() * sizeof(Brick); }

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
    bool is_changed = false;
    bool has_carries = false;  ///< now or formerly
  };

  /// `delta` is one, or its negative modulo 2^32.
  void Count(const Eigen::Vector3d& origin_W, const Eigen::Vector3d& end_W, std::uint32_t delta);
  Brick& ChangedBrick(const BrickKey& key);
  void Carry(const BrickKey& key, Brick& brick, std::size_t voxel, const VoxelCounts& carried);
  [[nodiscard]] VoxelCounts CountsOf(const BrickKey& key, const Brick& brick,
                                     std::size_t voxel) const;
  void Visit(const BrickKey& key, const Brick& brick, const VoxelVisitor& visit) const;

  double resolution_;
  std::unordered_map<BrickKey, Brick, BrickHash> bricks_;
  /// Of voxels by their number in the brick: times 65 536 to what the brick holds of them.
  std::unordered_map<BrickKey, std::map<std::size_t, VoxelCounts>, BrickHash> carries_;
  std::vector<BrickKey> changed_;
};

}  // namespace limpet
