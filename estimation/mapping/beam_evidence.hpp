// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "estimation/mapping/evidence_tile.hpp"

namespace limpet {

/// Log-odds of being occupied: OctoMap's sensor model (0.7 for a hit, 0.4 for a miss) and its
/// bounds, [0.12, 0.97] in probability, applied to the sums. [Hornung 2013] clamps after each beam
/// instead, so that there the last beams weigh most.
/// `before` is what was known of the voxel without these beams.
[[nodiscard]] float OccupiedLogOdds(const VoxelCounts& counts, float before = 0.0F);

/// What sonar beams say of space, as counts. Counts are sums, so a beam can be taken back exactly,
/// in any order, and laid elsewhere.
///
/// Memory. Of the tiles those used last are held, as many as fit; what the others held is dropped,
/// since the beams themselves say it again: who keeps them lays them again (Hold) where a dropped
/// tile is asked for. Beams that are counted meanwhile pass a dropped tile by.
class BeamEvidence {
 public:
  using VoxelVisitor = EvidenceTile::VoxelVisitor;
  using BeamVisitor =
      std::function<void(const Eigen::Vector3d& origin_W, const Eigen::Vector3d& end_W)>;
  /// What the tiles that are held may take together [bytes].
  static constexpr std::size_t kMostHeld = std::size_t{64} << 20U;

  /// `resolution` is a voxel's edge [m].
  explicit BeamEvidence(double resolution, std::size_t most_held = kMostHeld)
      : resolution_(resolution), most_held_(most_held) {}

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

  /// Drops what has not been used for longest until the rest fits; what was used last stays.
  void DropUnused();
  /// Whether beams have been in the tile and what they say of it has been dropped.
  [[nodiscard]] bool IsDropped(const TileKey& tile) const {
    const Tile* found = Find(tile);
    return found != nullptr && found->held == nullptr;
  }
  /// Makes a dropped tile anew: `beams` shows it all beams that may have been in it.
  void Hold(const TileKey& tile, const std::function<void(const BeamVisitor&)>& beams);

  /// Zeros where no beam has been. REQUIRES: of a tile that is not dropped.
  [[nodiscard]] VoxelCounts At(const VoxelKey& key) const;
  /// All voxels of a tile that beams have been in. REQUIRES: it is not dropped.
  void ForEachKnown(const TileKey& tile, const VoxelVisitor& visit) const;
  /// Those that beams have been in, by key.
  [[nodiscard]] std::vector<TileKey> Tiles() const;
  /// Those that beams have been laid in or taken back from since the last call, by key.
  [[nodiscard]] std::vector<TileKey> TakeChanged();
  [[nodiscard]] double resolution() const { return resolution_; }
  /// Size of the tiles that are held [bytes].
  [[nodiscard]] std::size_t bytes() const { return held_bytes_; }

 private:
  struct TileHash {
    std::size_t operator()(const TileKey& key) const;
  };
  struct Tile {
    std::unique_ptr<EvidenceTile> held;  ///< nothing: dropped
    std::uint64_t used = 0;              ///< the greater the later
    bool is_changed = false;
  };

  /// `delta` is one, or its negative modulo 2^32.
  void Count(const Eigen::Vector3d& origin_W, const Eigen::Vector3d& end_W, std::uint32_t delta);
  [[nodiscard]] BeamWalk WalkOf(const Eigen::Vector3d& origin_W,
                                const Eigen::Vector3d& end_W) const {
    return {origin_W / resolution_, end_W / resolution_};
  }

  /// Nothing where no beam has been. Beams and rays go from voxel to voxel: mostly it is the tile
  /// that was wanted before.
  [[nodiscard]] Tile* Find(const TileKey& tile) const;
  /// The tile, as one that is in use; nothing where no beam has been, or if it is dropped.
  [[nodiscard]] const EvidenceTile* Use(const TileKey& tile) const;
  /// Counts on in `held` and minds what that takes.
  bool CountIn(EvidenceTile& held, BeamWalk& walk, std::uint32_t delta);

  double resolution_;
  std::size_t most_held_;
  std::size_t held_bytes_ = 0;
  std::unordered_map<TileKey, std::unique_ptr<Tile>, TileHash> tiles_;
  mutable std::uint64_t uses_ = 0;
  mutable TileKey recent_key_;
  mutable Tile* recent_ = nullptr;
};

}  // namespace limpet
