// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/association/frame_associator.hpp"

namespace limpet {

/// True if the camera, with the body at `x`, should show the object, well inside the image.
[[nodiscard]] bool ShouldBeSeen(const TrackedObject& object, const NavVector& x,
                                const CameraModel& camera);

/// Counts, per track, that this frame should have shown it, and whether it did. `seen`: indices of
/// the tracks that it shows.
void CountVisibility(const Viewpoint& from, const std::vector<std::size_t>& seen,
                     const CameraMount& mount, const ObjectTrackerParams& params,
                     TrackList& tracks);

}  // namespace limpet
