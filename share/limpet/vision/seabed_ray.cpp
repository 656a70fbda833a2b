// SPDX-License-Identifier: MIT
#include "limpet/vision/seabed_ray.hpp"

#include <algorithm>

namespace limpet {

SeabedPoint SeabedRays::Meet(const Eigen::Vector3d& ray_W, double& distance) const {
  SeabedPoint met;
  for (int step = 0; step < 2; ++step) {
    const Eigen::Vector3d p_W = from_W_ + distance * ray_W;
    met.ground = relief_->At(p_W.head<2>());
    const SeabedRelief::Surface& ground = met.ground;
    const double closing =
        ray_W.z() - ground.slope_north * ray_W.x() - ground.slope_east * ray_W.y();
    distance = closing > 0.02 ? distance + (ground.depth - p_W.z()) / closing : farthest_;
    distance = std::clamp(distance, 0.05, farthest_);
  }
  met.p_W = from_W_ + distance * ray_W;
  return met;
}

}  // namespace limpet
