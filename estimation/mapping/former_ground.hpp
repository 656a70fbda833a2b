// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "estimation/mapping/semantic_octree.hpp"
#include "estimation/mapping/voxel_cluster.hpp"
#include "estimation/matching/frame_offset.hpp"

namespace limpet {

/// What a former session knew of the ground and the water above it, laid into this session's frame
/// as that becomes known. Of its log-odds half is kept, so that five beams that say otherwise
/// overrule it. Twenty bytes a cube, and sixteen a voxel that is laid.
class FormerGround {
 public:
  explicit FormerGround(double resolution) : resolution_(resolution) {}

  /// Of the former session's map what was seen of the ground.
  void Set(const SemanticOctree& former);
  /// The former session's frame in this one; steps that no voxel would show are none.
  void SetOffset(const FrameOffset& offset);
  /// Voxels lie as the offset now is.
  [[nodiscard]] bool is_laid() const { return is_laid_; }
  void Lay();

  /// Half of the log-odds that a voxel is occupied; nothing where the former session knew nothing.
  [[nodiscard]] std::optional<float> At(const VoxelKey& key) const;
  void ForEach(const std::function<void(const VoxelKey&, float occupied)>& visit) const;

 private:
  using Key = std::array<std::int32_t, 3>;
  /// Of `edge` voxels each way, in the former session's frame.
  struct Cube {
    Key corner;
    std::int32_t edge = 1;
    float occupied = 0.0F;
  };
  struct Laid {
    Key key;
    float occupied = 0.0F;
  };
  [[nodiscard]] Eigen::Vector3d CentreOfCube(const Cube& cube) const;

  double resolution_;
  std::vector<Cube> cubes_;
  FrameOffset offset_;
  std::vector<Laid> laid_;  ///< by key, each once
  bool is_laid_ = true;
};

}  // namespace limpet
