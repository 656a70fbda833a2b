// SPDX-License-Identifier: MIT
#include "estimation/association/track_placement.hpp"

#include <cmath>

namespace limpet {
namespace {

constexpr double kInTheGround = 1.0;  // [m] of a centre below the seabed where it was seen

void Locate(TrackedObject& object, const Smoother& smoother, const CameraMount& mount,
            const ObjectModel& model) {
  const Triangulation found = Triangulate(
      object.observations.all(), [&smoother](int node) { return smoother.PoseAt(node); }, mount,
      model);
  object.p_W = found.p_W;
  object.log_size = found.log_size;
  object.state =
      Tentative{.covariance_W = found.covariance_W, .worst_residual = found.worst_residual};
}

}  // namespace

void Place(TrackedObject& object, const Smoother& smoother, const CameraMount& mount,
           const ObjectModel& model) {
  Locate(object, smoother, mount, model);
  // No object is in the ground: the oldest observation then was of something else.
  const Observation& last = object.observations.back();
  if (object.observations.size() > 2 && last.altitude &&
      object.p_W.z() > smoother.PoseAt(last.node)(kNavZ) + *last.altitude + kInTheGround) {
    object.observations.RemoveFirst();
    object.sightings.CountAgain(object.observations.size());
    Locate(object, smoother, mount, model);
  }
}

bool IsPlaced(const TrackedObject& object, const ObjectTrackerParams& params) {
  return object.tentative().covariance_W.diagonal().maxCoeff() <=
         params.confirm_sd_m * params.confirm_sd_m;
}

double NewObjectCost(const TrackList& tracks, const ObjectTrackerParams& params) {
  return -2.0 * std::log(params.objects_per_m3 +
                         ClusteringOf(tracks.objects, params.pair_distance_m).pair_density);
}

}  // namespace limpet
