// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"

namespace limpet {

enum class BoxSide { kLow, kHigh };

/// One end of a box in an image. `axis` is the index that a point has along it: 0 for u, 1 for v.
struct BoxEnd {
  int axis = 0;
  BoxSide side = BoxSide::kHigh;
};

/// Where the image of a sphere ends, with the derivatives by its centre and its size.
struct SphereEdge {
  double px = 0.0;
  Eigen::RowVector3d by_p_C = Eigen::RowVector3d::Zero();  ///< [px/m]
  double by_log_radius = 0.0;                              ///< [px]
};

/// The end of what the image shows of a sphere about `p_C` [m]: the tangent to it, or, where the
/// border cuts off the point that this touches, the end of the chord along that border. Nothing
/// near the camera's plane or inside the sphere.
[[nodiscard]] std::optional<SphereEdge> EdgeOfSphere(const CameraModel& camera,
                                                     const Eigen::Vector3d& p_C, double radius,
                                                     BoxEnd end);

/// The image of a sphere along one axis, as if it had no border [px]: its ends, and where its
/// centre projects, which is not their middle.
struct SphereExtent {
  double low, centre, high;
};

/// Extent of a sphere about `p_C` [m]. One that is next to the camera, or holds it, ends far
/// outside any image, but somewhere.
[[nodiscard]] SphereExtent ExtentOfSphere(const CameraModel& camera, const Eigen::Vector3d& p_C,
                                          double radius, int axis);

}  // namespace limpet
