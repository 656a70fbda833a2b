// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/objects/status_posterior.hpp"

namespace limpet {

/// How the voxels of an object are labelled whose status was decided so.
[[nodiscard]] VoxelLabel LabelOf(Status decided);
/// What was decided about the object of a voxel so labelled; nothing of the ground's.
[[nodiscard]] std::optional<Status> StatusOf(VoxelLabel label);

}  // namespace limpet
