// SPDX-License-Identifier: MIT
#include "estimation/mapping/semantic_map.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/mapping/map_export.hpp"

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
  return GroundAt(key, beams_.evidence().At(key));
}

bool SemanticMap::IsClear(const VoxelKey& key) const {
  const auto painted = painted_.find(key);
  return (painted == painted_.end() || painted->second.occupied <= 0.0F) &&
         OccupiedLogOdds(beams_.evidence().At(key)) <= 0.0F;
}

std::optional<VoxelBelief> SemanticMap::GroundAt(const VoxelKey& key,
                                                 const VoxelCounts& counts) const {
  const std::optional<VoxelBelief> former =
      laid_former_ ? laid_former_->At(CentreOf(key, resolution())) : std::nullopt;
  if (!former && !counts.is_known()) return std::nullopt;
  return VoxelBelief{.occupied = OccupiedLogOdds(counts, former ? former->occupied : 0.0F)};
}

void SemanticMap::SetFormer(const SemanticOctree& former) {
  /// Beams do not fill cubes wider than so many voxels with the same.
  constexpr double kWidest = 64.0;
  former_.clear();
  former.ForEachLeaf([&](const Voxel& voxel) {
    const bool is_known_ground =
        voxel.belief.label == VoxelLabel::kGround && voxel.belief.occupied != 0.0F;
    if (is_known_ground && voxel.size <= kWidest * resolution()) former_.push_back(voxel);
  });
  is_former_laid_ = former_.empty() && !laid_former_;
}

void SemanticMap::SetFormerOffset(const FrameOffset& offset) {
  /// Steps that are not worth laying it again: voxels are no finer.
  const double least = 0.25 * resolution();
  double farthest = 0.0;
  for (const Voxel& voxel : former_) {
    const Eigen::Vector3d step = offset.Apply(voxel.p_W) - former_offset_.Apply(voxel.p_W);
    farthest = std::max(farthest, step.norm());
  }
  if (farthest > least) {
    former_offset_ = offset;
    is_former_laid_ = false;
  }
}

void SemanticMap::LayFormer() {
  constexpr float kKept = 0.5F;
  laid_former_.emplace(Meters(resolution()));
  for (const Voxel& leaf : former_) {
    const int n = std::max(1, static_cast<int>(std::lround(leaf.size / resolution())));
    const float occupied = kKept * leaf.belief.occupied;
    for (int i = 0; i < n * n * n; ++i) {
      const Eigen::Vector3d cell(i % n + 0.5, i / n % n + 0.5, i / n / n + 0.5);
      const Eigen::Vector3d corner = leaf.p_W - Eigen::Vector3d::Constant(0.5 * leaf.size);
      const Eigen::Vector3d p_W = former_offset_.Apply(corner + cell * (leaf.size / n));
      // Where two come to lie in one voxel, what is occupied stays so.
      const std::optional<VoxelBelief> other = laid_former_->At(p_W);
      if (!other || other->occupied < occupied) laid_former_->Set(p_W, {.occupied = occupied});
    }
  }
  is_former_laid_ = true;
}

bool SemanticMap::Refresh(const VoxelKey& key) {
  const Eigen::Vector3d p_W = CentreOf(key, resolution());
  const std::optional<VoxelBelief> belief = At(key);
  if (belief) octree_.Set(p_W, *belief);
  return belief || !octree_.At(p_W);
}

void SemanticMap::Rebuild() {
  octree_ = SemanticOctree(Meters(resolution()));
  if (laid_former_) {
    laid_former_->ForEachLeaf([this](const Voxel& leaf) {
      octree_.Set(leaf.p_W, leaf.belief);  // each as wide as a voxel: they were never merged
    });
  }
  beams_.evidence().ForEachKnown([this](const VoxelKey& key, const VoxelCounts& counts) {
    octree_.Set(CentreOf(key, resolution()), *GroundAt(key, counts));
  });
  for (const auto& [key, belief] : painted_) {
    octree_.Set(CentreOf(key, resolution()), belief);
  }
}

void SemanticMap::SetGroundOdds(const GroundOdds& object) {
  for (const Voxel& voxel : OccupiedVoxels(octree_)) {
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
  bool is_complete = is_former_laid_;
  if (!is_former_laid_) LayFormer();
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
