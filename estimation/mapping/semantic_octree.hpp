// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/expected.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// What a voxel stands for in pictures; of its object's posterior.
enum class VoxelLabel : std::uint8_t {
  kGround = 0,
  kUncertain = 1,
  kConfirmed = 2,
  kRemoved = 3,
  kNew = 4,
  kMoved = 5
};

/// Beliefs of one voxel, in log-odds.
struct VoxelBelief {
  float occupied = 0.0F;  ///< P_o
  float object = 0.0F;    ///< P_a: it belongs to an object of interest
  float exists = 0.0F;    ///< P_e: what it belongs to is there now
  VoxelLabel label = VoxelLabel::kGround;
  bool operator==(const VoxelBelief&) const = default;
};

/// A leaf of the tree; large leaves stand for many equal voxels.
struct Voxel {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< centre, NED [m]
  double size = 0.0;                              ///< edge [m]
  VoxelBelief belief;
};

/// Most that a voxel's log-odds of its object and of its being there come to, either way.
inline constexpr double kMostVoxelLogOdds = 3.5;

/// A map as it is saved and read: an octree over NED whose voxels know whether they are occupied,
/// belong to an object, and whether that object is there now. Log-odds are clamped to [0.12, 0.97]
/// in probability for occupancy [Hornung 2013] and to +-kMostVoxelLogOdds for the others.
class SemanticOctree {
 public:
  explicit SemanticOctree(Meters resolution = Meters(0.2));
  ~SemanticOctree();
  SemanticOctree(const SemanticOctree&) = delete;
  SemanticOctree& operator=(const SemanticOctree&) = delete;
  SemanticOctree(SemanticOctree&&) noexcept;
  SemanticOctree& operator=(SemanticOctree&&) noexcept;

  /// Sets all beliefs of the voxel at a point. No effect beyond 32 768 voxels from the origin.
  void Set(const Eigen::Vector3d& p_W, const VoxelBelief& belief);

  /// Nothing where the map knows nothing.
  [[nodiscard]] std::optional<VoxelBelief> At(const Eigen::Vector3d& p_W) const;
  /// Centre of the voxel that holds the point.
  [[nodiscard]] Eigen::Vector3d CentreOf(const Eigen::Vector3d& p_W) const;
  [[nodiscard]] double resolution() const;
  [[nodiscard]] std::size_t nodes() const;
  /// All leaves, in the tree's order.
  void ForEachLeaf(const std::function<void(const Voxel&)>& visit) const;
  [[nodiscard]] std::vector<Voxel> Leaves() const;

  /// Equal voxels side by side are merged first, so that equal maps give equal bytes. OctoMap's
  /// `.ot` stream of tree type SemanticOcTree; payload per node: l_o, l_a, l_e as f32, label as u8.
  [[nodiscard]] std::string Serialize() const;
  /// Checks every byte's place before it builds the tree: OctoMap's own reader trusts its input.
  [[nodiscard]] static Expected<SemanticOctree> Parse(const std::string& bytes);
  /// Takes over a leaf of another one, of voxels as large: sets each of the voxels that it is.
  void AddLeaf(const Voxel& leaf);
  /// Merges equal voxels side by side.
  void Merge();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limpet
