// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/objects/status_posterior.hpp"

namespace limpet {

/// How the voxels of an object are labelled whose status was decided so.
[[nodiscard]] VoxelLabel LabelOf(Status decided);

}  // namespace limpet
