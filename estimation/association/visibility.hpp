// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/association/frame_associator.hpp"

namespace limpet {

/// Counts, per track, that this frame should have shown it, and whether it did. `seen`: indices of
/// the tracks that it shows.
void CountVisibility(const Viewpoint& from, const std::vector<std::size_t>& seen,
                     const CameraMount& mount, const ObjectTrackerParams& params,
                     TrackList& tracks);

}  // namespace limpet
