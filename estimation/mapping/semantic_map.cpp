// SPDX-License-Identifier: MIT
#include "estimation/mapping/semantic_map.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/mapping/map_export.hpp"

namespace limpet {

SemanticMap::SemanticMap(Meters resolution, const DvlBeams& dvl)
    : beams_(resolution, dvl), former_(resolution.value()), octree_(resolution) {}

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
  return GroundAt(key, beams_.evidence().At(key));
}

bool SemanticMap::IsClear(const VoxelKey& key) const {
  const auto painted = painted_.find(key);
  return (painted == painted_.end() || painted->second.occupied <= 0.0F) &&
         OccupiedLogOdds(beams_.evidence().At(key)) <= 0.0F;
}

std::optional<VoxelBelief> SemanticMap::GroundAt(const VoxelKey& key,
                                                 const VoxelCounts& counts) const {
  const std::optional<float> former = former_.At(key);
  if (!former && !counts.is_known()) return std::nullopt;
  return VoxelBelief{.occupied = OccupiedLogOdds(counts, former.value_or(0.0F))};
}

bool SemanticMap::Refresh(const VoxelKey& key) {
  const Eigen::Vector3d p_W = CentreOf(key, resolution());
  const std::optional<VoxelBelief> belief = At(key);
  if (belief) octree_.Set(p_W, *belief);
  return belief || !octree_.At(p_W);
}

void SemanticMap::Rebuild() {
  octree_ = SemanticOctree(Meters(resolution()));
  former_.ForEach([this](const VoxelKey& key, float occupied) {
    octree_.Set(CentreOf(key, resolution()), {.occupied = occupied});
  });
  beams_.evidence().ForEachKnown([this](const VoxelKey& key, const VoxelCounts& counts) {
    octree_.Set(CentreOf(key, resolution()), *GroundAt(key, counts));
  });
  for (const auto& [key, belief] : painted_) {
    octree_.Set(CentreOf(key, resolution()), belief);
  }
}

void SemanticMap::SetGroundOdds(const GroundOdds& object) {
  const OccupiedMap occupied = OccupiedOf(octree_);
  for (const Voxel& voxel : occupied.voxels) {
    if (voxel.belief.label != VoxelLabel::kGround) continue;
    VoxelBelief belief = voxel.belief;
    belief.object = object(KeyOf(voxel.p_W, resolution()));
    if (belief != voxel.belief) octree_.Set(voxel.p_W, belief);
  }
}

// OctoMap 1.9.7 cannot take a voxel out again (its deleteNode aborts when it takes a node's last
// child), so a map that has lost one is built anew.
const SemanticOctree& SemanticMap::Octree(const GroundOdds& object) {
  beams_.SettleAll();
  bool is_complete = former_.is_laid();
  if (!is_complete) former_.Lay();
  beams_.evidence().TakeChanged([&](const VoxelKey& key, const VoxelCounts& counts) {
    if (counts.is_known() && !painted_.contains(key)) {
      octree_.Set(CentreOf(key, resolution()), *GroundAt(key, counts));
    } else if (is_complete) {
      is_complete = Refresh(key);
    }
  });
  for (const VoxelKey& key : repainted_) {
    is_complete = Refresh(key) && is_complete;
  }
  repainted_.clear();
  if (!is_complete) Rebuild();
  if (object) SetGroundOdds(object);
  return octree_;
}

}  // namespace limpet
