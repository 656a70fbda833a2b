// SPDX-License-Identifier: MIT
// What became of a former object near which another is now: it is that one, still there or moved,
// or it is gone and another one came.
#pragma once

#include <Eigen/Core>

#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// How far an object is from where a former one was, in this session's frame, and how surely. Depth
/// is weighed by itself: it has a sensor of its own.
struct Displacement {
  Eigen::Vector3d off_W = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d cov_W = Eigen::Matrix3d::Zero();  ///< of `off_W` [m^2]
};

/// Densities of the displacement [1/m^3], each times its chance before it is seen, where the former
/// object or another one is there now.
struct MoveHypotheses {
  double stayed = 0.0;
  double moved = 0.0;
  double replaced = 0.0;  ///< gone, and another one came
};

/// Moves of half a metre to `farthest` [m], over the ground, or up or down alone.
[[nodiscard]] MoveHypotheses WeighMoves(const Displacement& displacement, double farthest);

/// That one object has moved, where the former place is empty and another is taken: `former` in
/// this session's frame, and both of one colour.
[[nodiscard]] double ChanceMoved(const ObjectEstimate& former, const ObjectEstimate& now,
                                 double farthest);

}  // namespace limpet
