// SPDX-License-Identifier: MIT
#include "estimation/association/visibility.hpp"

#include <algorithm>

#include "estimation/smoothing/camera_point.hpp"

namespace limpet {
namespace {

constexpr double kSlack = 0.5;         // [m] beyond the distance it was seen at
constexpr double kNearest = 0.5;       // [m] in front of the camera
constexpr double kMarginShare = 0.12;  // of the image, inside which an object should be seen

}  // namespace

bool ShouldBeSeen(const TrackedObject& object, const NavVector& x, const CameraModel& camera) {
  const double reach = object.sightings.max_distance + kSlack + camera.p_BC.norm();
  if ((object.p_W - x.head<3>()).squaredNorm() > reach * reach) {
    return false;  // most of them, most of the time
  }
  const Eigen::Vector3d p = CameraPointOf(camera, x, object.p_W).p_C;
  if (p.z() < kNearest || p.norm() > object.sightings.max_distance + kSlack) {
    return false;
  }
  const double u = (camera.cx + camera.fx * p.x() / p.z()) / camera.width_px;
  const double v = (camera.cy + camera.fy * p.y() / p.z()) / camera.height_px;
  return std::min({u, 1.0 - u, v, 1.0 - v}) > kMarginShare;
}

void CountVisibility(const Viewpoint& from, const std::vector<std::size_t>& seen,
                     const CameraMount& mount, const ObjectTrackerParams& params,
                     TrackList& tracks) {
  const CameraModel camera = mount.At(from.motion);
  for (std::size_t j = 0; j < tracks.objects.size(); ++j) {
    TrackedObject& object = tracks.objects[j];
    const bool is_seen = std::ranges::count(seen, j) > 0;
    if (!is_seen && !ShouldBeSeen(object, from.x, camera)) continue;
    if (object.is_mapped() && !tracks.TakesObservations(object, params.confirm_within_s)) continue;
    if (is_seen) {
      ++object.sightings.expected;
      ++object.sightings.hits;
      continue;
    }
    // What is open and seen now may be this one.
    const auto may_be_it = [&](std::size_t k) {
      const TrackedObject& other = tracks.objects[k];
      return other.is_open() && (other.p_W - object.p_W).norm() < params.merge_distance_m;
    };
    if (object.is_mapped() && std::ranges::any_of(seen, may_be_it)) continue;
    ++object.sightings.expected;
  }
}

}  // namespace limpet
