// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/mapping/sampled_sphere.hpp"

namespace limpet {

/// Index of a voxel along north, east, down: floor of the coordinate over the resolution.
using VoxelKey = std::array<std::int64_t, 3>;
[[nodiscard]] VoxelKey KeyOf(const Eigen::Vector3d& p_W, double resolution);
[[nodiscard]] Eigen::Vector3d CentreOf(const VoxelKey& key, double resolution);

/// Connected voxels of one object.
struct ObjectCluster {
  Eigen::Vector3d centre_W = Eigen::Vector3d::Zero();     ///< of the sphere they lie on, NED [m]
  Eigen::Vector3d deviation_W = Eigen::Vector3d::Zero();  ///< of the voxels about their mean [m]
  int voxels = 0;
};

/// The largest set of voxels that touch each other (faces, edges or corners), and the sphere of
/// that radius that its points sample from above. Nothing if there are no voxels.
[[nodiscard]] std::optional<ObjectCluster> LargestCluster(const std::vector<VoxelKey>& voxels,
                                                          const SampledSphere& sphere);

}  // namespace limpet
