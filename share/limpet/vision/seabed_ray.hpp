// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/vision/seabed_relief.hpp"

namespace limpet {

/// Where a ray meets the seabed.
struct SeabedPoint {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  SeabedRelief::Surface ground;  ///< near there: as of the last step towards it
};

/// Rays to the seabed of a camera at one place.
class SeabedRays {
 public:
  /// `farthest`: of a ray, in units of itself; for rays that meet nothing. `relief` must outlive
  /// it.
  SeabedRays(SeabedRelief& relief, const Eigen::Vector3d& from_W, double farthest)
      : relief_(&relief), from_W_(from_W), farthest_(farthest) {}

  /// Two Newton steps from `distance`, in units of the ray, which becomes that of the point: a
  /// neighbour's distance is a good one to begin with.
  [[nodiscard]] SeabedPoint Meet(const Eigen::Vector3d& ray_W, double& distance) const;

 private:
  SeabedRelief* relief_;
  Eigen::Vector3d from_W_;
  double farthest_;
};

}  // namespace limpet
