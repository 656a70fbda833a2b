// SPDX-License-Identifier: MIT
#include "estimation/mapping/former_ground.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

/// Beams do not fill cubes wider than so many voxels with the same.
constexpr double kWidest = 64.0;
constexpr float kKept = 0.5F;

std::array<std::int32_t, 3> Narrow(const VoxelKey& key) {
  return {static_cast<std::int32_t>(key[0]), static_cast<std::int32_t>(key[1]),
          static_cast<std::int32_t>(key[2])};
}

VoxelKey Wide(const std::array<std::int32_t, 3>& key) { return {key[0], key[1], key[2]}; }

}  // namespace

void FormerGround::Set(const SemanticOctree& former) {
  cubes_.clear();
  former.ForEachLeaf([this](const Voxel& leaf) {
    const bool is_known_ground =
        leaf.belief.label == VoxelLabel::kGround && leaf.belief.occupied != 0.0F;
    if (!is_known_ground || leaf.size > kWidest * resolution_) return;
    const Eigen::Vector3d first =
        leaf.p_W + Eigen::Vector3d::Constant(0.5 * (resolution_ - leaf.size));
    cubes_.push_back({.corner = Narrow(KeyOf(first, resolution_)),
                      .edge = std::max(1, static_cast<int>(std::lround(leaf.size / resolution_))),
                      .occupied = leaf.belief.occupied});
  });
  cubes_.shrink_to_fit();
  is_laid_ = cubes_.empty() && laid_.empty();
}

Eigen::Vector3d FormerGround::CentreOfCube(const Cube& cube) const {
  return CentreOf(Wide(cube.corner), resolution_) +
         Eigen::Vector3d::Constant(0.5 * (cube.edge - 1) * resolution_);
}

void FormerGround::SetOffset(const FrameOffset& offset) {
  const double least = 0.25 * resolution_;
  double farthest = 0.0;
  for (const Cube& cube : cubes_) {
    const Eigen::Vector3d centre = CentreOfCube(cube);
    farthest = std::max(farthest, (offset.Apply(centre) - offset_.Apply(centre)).norm());
  }
  if (farthest > least) {
    offset_ = offset;
    is_laid_ = false;
  }
}

void FormerGround::Lay() {
  laid_.clear();
  for (const Cube& cube : cubes_) {
    const int n = cube.edge;
    for (int i = 0; i < n * n * n; ++i) {
      const VoxelKey cell{cube.corner[0] + i % n, cube.corner[1] + i / n % n,
                          cube.corner[2] + i / n / n};
      const Eigen::Vector3d p_W = offset_.Apply(CentreOf(cell, resolution_));
      laid_.push_back({.key = Narrow(KeyOf(p_W, resolution_)), .occupied = kKept * cube.occupied});
    }
  }
  // Where two come to lie in one voxel, what is occupied stays so.
  std::ranges::sort(laid_, [](const Laid& a, const Laid& b) {
    return a.key != b.key ? a.key < b.key : a.occupied > b.occupied;
  });
  const auto end = std::unique(laid_.begin(), laid_.end(),
                               [](const Laid& a, const Laid& b) { return a.key == b.key; });
  laid_.erase(end, laid_.end());
  laid_.shrink_to_fit();
  is_laid_ = true;
}

std::optional<float> FormerGround::At(const VoxelKey& key) const {
  const Key wanted = Narrow(key);
  const auto found = std::ranges::lower_bound(laid_, wanted, {}, &Laid::key);
  return found != laid_.end() && found->key == wanted ? std::optional(found->occupied)
                                                      : std::nullopt;
}

void FormerGround::ForEach(
    const std::function<void(const VoxelKey&, float occupied)>& visit) const {
  for (const Laid& laid : laid_) {
    visit(Wide(laid.key), laid.occupied);
  }
}

}  // namespace limpet
