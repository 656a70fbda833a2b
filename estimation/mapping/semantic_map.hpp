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
/// former session knew, and on top of it the objects as they are painted. The octree is made of it
/// when somebody reads or saves.
class SemanticMap {
 public:
  explicit SemanticMap(Meters resolution = Meters(0.2), const DvlBeams& dvl = {});

  [[nodiscard]] BeamMap& beams() { return beams_; }
  [[nodiscard]] const BeamMap& beams() const { return beams_; }
  /// An object's voxel: stands in for what beams say there.
  void Paint(const VoxelKey& key, const VoxelBelief& belief);
  /// What beams say is to stand there again.
  void Unpaint(const VoxelKey& key);
  /// What a former session knew of the ground (former_ground.hpp); its objects are left out: they
  /// come as objects.
  void SetFormer(const SemanticOctree& former) { former_.Set(former); }
  /// The former session's frame in this one, as far as it is known: its voxels are laid there.
  void SetFormerOffset(const FrameOffset& offset) { former_.SetOffset(offset); }
  /// Nothing where the map knows nothing.
  [[nodiscard]] std::optional<VoxelBelief> At(const VoxelKey& key) const;
  /// False where something is that one cannot look through, an object or the seabed.
  [[nodiscard]] bool IsClear(const VoxelKey& key) const;
  [[nodiscard]] double resolution() const { return beams_.evidence().resolution(); }

  /// ln P_a / (1 - P_a) of ground in a voxel.
  using GroundOdds = std::function<float(const VoxelKey&)>;
  /// The whole map, with shifts of the track that still wait. Depends on what the map holds, not on
  /// how it came to hold it. `object` is what is said of voxels that are occupied and no object's.
  [[nodiscard]] const SemanticOctree& Octree(const GroundOdds& object = {});

 private:
  /// False if the octree has a voxel there of which nothing is known any more.
  [[nodiscard]] bool Refresh(const VoxelKey& key);
  void Rebuild();
  void SetGroundOdds(const GroundOdds& object);
  /// Of what beams and a former session say; nothing if neither says anything.
  [[nodiscard]] std::optional<VoxelBelief> GroundAt(const VoxelKey& key,
                                                    const VoxelCounts& counts) const;

  BeamMap beams_;
  std::map<VoxelKey, VoxelBelief> painted_;
  std::set<VoxelKey> repainted_;  ///< since the octree was last made
  FormerGround former_;
  SemanticOctree octree_;
};

}  // namespace limpet
