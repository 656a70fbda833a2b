// SPDX-License-Identifier: MIT
#include "estimation/mapping/voxel_cluster.hpp"

#include <cmath>
#include <set>

#include "estimation/mapping/object_look.hpp"

namespace limpet {
namespace {

/// Takes the connected set of `seed` out of `left`.
std::vector<VoxelKey> TakeConnected(std::set<VoxelKey>& left, const VoxelKey& seed) {
  std::vector<VoxelKey> cluster{seed};
  left.erase(seed);
  for (std::size_t next = 0; next < cluster.size(); ++next) {
    const VoxelKey at = cluster[next];
    for (int i = 0; i < 27; ++i) {
      const VoxelKey neighbour{at[0] + i % 3 - 1, at[1] + i / 3 % 3 - 1, at[2] + i / 9 - 1};
      if (left.erase(neighbour) > 0) {
        cluster.push_back(neighbour);
      }
    }
  }
  return cluster;
}

ObjectCluster Describe(const std::vector<VoxelKey>& keys, double radius, double resolution) {
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const VoxelKey& key : keys) {
    points.push_back(CentreOf(key, resolution));
    mean += points.back() / static_cast<double>(keys.size());
  }
  // Within its voxel a point may be anywhere.
  Eigen::Vector3d variance = Eigen::Vector3d::Constant(resolution * resolution / 12.0);
  for (const Eigen::Vector3d& point : points) {
    variance += (point - mean).cwiseAbs2() / static_cast<double>(keys.size());
  }
  return {.centre_W = SphereCentre(points, radius).value_or(mean),
          .deviation_W = variance.cwiseSqrt(),
          .voxels = static_cast<int>(keys.size())};
}

}  // namespace

VoxelKey KeyOf(const Eigen::Vector3d& p_W, double resolution) {
  const auto index = [resolution](double x) {
    return static_cast<std::int64_t>(std::floor(x / resolution));
  };
  return {index(p_W.x()), index(p_W.y()), index(p_W.z())};
}

Eigen::Vector3d CentreOf(const VoxelKey& key, double resolution) {
  return resolution * (Eigen::Vector3d(static_cast<double>(key[0]), static_cast<double>(key[1]),
                                       static_cast<double>(key[2])) +
                       Eigen::Vector3d::Constant(0.5));
}

std::optional<ObjectCluster> LargestCluster(const std::vector<VoxelKey>& voxels,
                                            const SampledSphere& sphere) {
  std::set<VoxelKey> left(voxels.begin(), voxels.end());
  std::vector<VoxelKey> largest;
  while (!left.empty()) {
    std::vector<VoxelKey> cluster = TakeConnected(left, *left.begin());
    if (cluster.size() > largest.size()) {
      largest = std::move(cluster);
    }
  }
  return largest.empty()
             ? std::nullopt
             : std::optional<ObjectCluster>(Describe(largest, sphere.radius, sphere.spacing));
}

}  // namespace limpet
