// SPDX-License-Identifier: MIT
#include "estimation/mapping/semantic_map.hpp"

namespace limpet {

SemanticMap::SemanticMap(Meters resolution, const DvlBeams& dvl)
    : beams_(resolution, dvl), octree_(resolution) {}

void SemanticMap::Paint(const VoxelKey& key, const VoxelBelief& belief) {
  painted_[key] = belief;
  repainted_.insert(key);
}

void SemanticMap::Unpaint(const VoxelKey& key) {
  painted_.erase(key);
  repainted_.insert(key);
}

std::optional<VoxelBelief> SemanticMap::At(const VoxelKey& key) const {
  if (const auto painted = painted_.find(key); painted != painted_.end()) {
    return painted->second;
  }
  const VoxelCounts counts = beams_.evidence().At(key);
  return counts.is_known() ? std::optional(VoxelBelief{.occupied = OccupiedLogOdds(counts)})
                           : std::nullopt;
}

bool SemanticMap::Refresh(const VoxelKey& key) {
  const Eigen::Vector3d p_W = CentreOf(key, resolution());
  const std::optional<VoxelBelief> belief = At(key);
  if (belief) octree_.Set(p_W, *belief);
  return belief || !octree_.At(p_W);
}

void SemanticMap::Rebuild() {
  octree_ = SemanticOctree(Meters(resolution()));
  beams_.evidence().ForEachKnown([this](const VoxelKey& key, const VoxelCounts& counts) {
    octree_.Set(CentreOf(key, resolution()), {.occupied = OccupiedLogOdds(counts)});
  });
  for (const auto& [key, belief] : painted_) {
    octree_.Set(CentreOf(key, resolution()), belief);
  }
}

// OctoMap 1.9.7 cannot take a voxel out again (its deleteNode aborts when it takes a node's last
// child), so a map that has lost one is built anew.
const SemanticOctree& SemanticMap::Octree() {
  beams_.SettleAll();
  bool is_complete = true;
  beams_.evidence().TakeChanged([&](const VoxelKey& key, const VoxelCounts& counts) {
    if (counts.is_known() && !painted_.contains(key)) {
      octree_.Set(CentreOf(key, resolution()), {.occupied = OccupiedLogOdds(counts)});
    } else if (is_complete) {
      is_complete = Refresh(key);
    }
  });
  for (const VoxelKey& key : repainted_) {
    is_complete = Refresh(key) && is_complete;
  }
  repainted_.clear();
  if (!is_complete) Rebuild();
  return octree_;
}

}  // namespace limpet
