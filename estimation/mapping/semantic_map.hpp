// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>

#include "estimation/mapping/beam_map.hpp"
#include "estimation/mapping/semantic_octree.hpp"
#include "estimation/mapping/voxel_cluster.hpp"

namespace limpet {

/// The map of record while a session goes on: what beams say of space, and on top of it the objects
/// as they are painted. The octree is made of it when somebody reads or saves.
class SemanticMap {
 public:
  explicit SemanticMap(Meters resolution = Meters(0.2), const DvlBeams& dvl = {});

  [[nodiscard]] BeamMap& beams() { return beams_; }
  [[nodiscard]] const BeamMap& beams() const { return beams_; }
  /// An object's voxel: stands in for what beams say there.
  void Paint(const VoxelKey& key, const VoxelBelief& belief);
  /// What beams say is to stand there again.
  void Unpaint(const VoxelKey& key);
  /// Nothing where the map knows nothing.
  [[nodiscard]] std::optional<VoxelBelief> At(const VoxelKey& key) const;
  [[nodiscard]] double resolution() const { return beams_.evidence().resolution(); }

  /// The whole map, with shifts of the track that still wait. Depends on what the map holds, not on
  /// how it came to hold it.
  [[nodiscard]] const SemanticOctree& Octree();

 private:
  /// False if the octree has a voxel there of which nothing is known any more.
  [[nodiscard]] bool Refresh(const VoxelKey& key);
  void Rebuild();

  BeamMap beams_;
  std::map<VoxelKey, VoxelBelief> painted_;
  std::set<VoxelKey> repainted_;  ///< since the octree was last made
  SemanticOctree octree_;
};

}  // namespace limpet
