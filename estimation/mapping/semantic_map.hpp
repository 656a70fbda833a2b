// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "estimation/mapping/beam_map.hpp"
#include "estimation/mapping/former_ground.hpp"
#include "estimation/mapping/semantic_octree.hpp"
#include "estimation/mapping/voxel_cluster.hpp"
#include "estimation/matching/frame_offset.hpp"

namespace limpet {

/// The map of record while a session goes on: what beams say of space, what is left of what a
/// former session knew, and on top of it the objects as they are painted. Octrees are made of it,
/// tile by tile, when somebody reads or saves.
class SemanticMap {
 public:
  explicit SemanticMap(Meters resolution = Meters(0.2), const DvlBeams& dvl = {},
                       std::size_t most_held = BeamEvidence::kMostHeld);

  [[nodiscard]] BeamMap& beams() { return beams_; }
  [[nodiscard]] const BeamMap& beams() const { return beams_; }
  /// An object's voxel: stands in for what beams say there.
  void Paint(const VoxelKey& key, const VoxelBelief& belief);
  /// What beams say is to stand there again.
  void Unpaint(const VoxelKey& key);
  /// A tile of what a former session knew of the ground (former_ground.hpp); its objects are left
  /// out: they come as objects. The error says why it is not taken.
  [[nodiscard]] std::optional<Error> AddFormer(const MapTile& tile);
  /// The former session's frame in this one, as far as it is known: its voxels are laid there.
  void SetFormerOffset(const FrameOffset& offset);
  /// Nothing where the map knows nothing.
  [[nodiscard]] std::optional<VoxelBelief> At(const VoxelKey& key) const;
  /// False where something is that one cannot look through, an object or the seabed.
  [[nodiscard]] bool IsClear(const VoxelKey& key) const;
  [[nodiscard]] double resolution() const { return beams_.resolution(); }

  /// ln P_a / (1 - P_a) of ground in a voxel.
  using GroundOdds = std::function<float(const VoxelKey&)>;
  /// Tiles that may be other than when this was last called, by key, also such as know nothing any
  /// more; with shifts of the track that still wait.
  [[nodiscard]] std::vector<TileKey> TakeChanged();
  /// Tiles that something may be known of, by key.
  [[nodiscard]] std::vector<TileKey> Tiles() const;
  /// A tile of the map. Depends on what the map holds, not on how it came to hold it. `object` is
  /// what is said of voxels that are occupied and no object's.
  [[nodiscard]] SemanticOctree OctreeOf(const TileKey& tile, const GroundOdds& object = {}) const;

 private:
  using Painted = std::map<VoxelKey, VoxelBelief>;

  BeamMap beams_;
  std::map<TileKey, Painted> painted_;
  FormerGround former_;
  std::set<TileKey> changed_;  ///< by other than beams
};

}  // namespace limpet
