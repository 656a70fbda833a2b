// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// A scene of MRPT's (COpenGLScene, what a .3Dscene file holds, before compression), which
/// SceneViewer3D opens; x east, y north, z up. Its objects:
///   seabed     COctoMapVoxels: occupied voxels in the colours of ColorOf, a set per VoxelLabel
///   objects    CSetOfObjects: of each object an ellipsoid of three sigmas, "object <id>", in its
///              status' colour, and its id, class and status as text; not of what is decided
///              to be nothing
///   path       CSetOfLines through `path_W`, if that has two points or more
///   origin     axes of 1 m at the mission's origin
[[nodiscard]] std::string ToScene(const SemanticOctree& octree,
                                  const std::vector<OpiBelief>& objects,
                                  const std::vector<Eigen::Vector3d>& path_W);

}  // namespace limpet
