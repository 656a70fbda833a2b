// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/association/track_list.hpp"
#include "estimation/association/tracker_params.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// Place of a tentative track from its observations; one that cannot be of it goes.
void Place(TrackedObject& object, const Smoother& smoother, const CameraMount& mount,
           const ObjectModel& model);

/// True if its place is known well enough for the smoother. REQUIRES: it is tentative.
[[nodiscard]] bool IsPlaced(const TrackedObject& object, const ObjectTrackerParams& params);

/// -2 ln of the density of objects that are not known yet, near known ones [1/m^3].
[[nodiscard]] double NewObjectCost(const TrackList& tracks, const ObjectTrackerParams& params);

}  // namespace limpet
