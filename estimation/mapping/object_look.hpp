// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/change/place_watch.hpp"
#include "estimation/mapping/sampled_sphere.hpp"

namespace limpet {

/// A voxel that a look touched, and what the look says about it: ln(P / (1 - P)) of belonging to an
/// object.
struct VoxelEvidence {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< a point of the near surface, NED [m]
  double log_odds = 0.0;
};

/// A pixel's place in a box.
struct BoxPixel {
  double r_px = 0.0;  ///< from the box's centre
  double s_px = 0.0;  ///< half the box's size
};

/// P = 0.5 + (p_c - 0.5) exp(-r^2 / 2 s^2): how much a pixel at distance r from the centre of a box
/// of half size s and confidence `p_c` belongs to the object ([Bucci 2025] eq. (8) with
/// its floor at one half, so that the box's border is no evidence against).
[[nodiscard]] double ObjectProbability(const BoxPixel& pixel, double confidence);

/// The box that a cut one would be in a larger image: from the edges that show, and from its free
/// side; in a corner, from the object's half size `half_px` alone. Whole boxes stay as they are.
[[nodiscard]] Box WholeBox(const Box& box, const Eigen::Vector2d& half_px,
                           const CameraModel& camera);

/// One independent look at an object: its box, seen from a pose.
struct ObjectLook {
  Pose X_WB;
  Box box;  ///< whole; what lies outside the image was not seen
  Eigen::Vector3d object_W = Eigen::Vector3d::Zero();  ///< the smoother's centre then, NED [m]
  double time = 0.0;                                   ///< [s]
};

/// Radius of the sphere that fills the look's box at the object's range [m].
[[nodiscard]] double RadiusFromBox(const ObjectLook& look, const CameraModel& camera);

/// The near surface of the sphere in the box: the box is divided into cells whose rays meet the
/// sphere around the box's centre ray at the object's range; cells outside the image say nothing.
[[nodiscard]] std::vector<VoxelEvidence> NearSurface(const ObjectLook& look,
                                                     const CameraModel& camera,
                                                     const SampledSphere& sphere);

/// Centre of the sphere of `radius` whose surface the points sample from above: least squares on
/// the distances. Nothing for fewer than four points.
[[nodiscard]] std::optional<Eigen::Vector3d> SphereCentre(
    const std::vector<Eigen::Vector3d>& points_W, double radius);

}  // namespace limpet
