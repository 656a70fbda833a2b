// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// Third component of the cross product of two vectors of a plane: positive where the way from `a`
/// to `b` turns as that from the first axis to the second. With north and east for axes that is
/// to starboard.
[[nodiscard]] inline double CrossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The skew-symmetric matrix S with S u = v x u for every u.
[[nodiscard]] inline Eigen::Matrix3d CrossMatrixOf(const Eigen::Vector3d& v) {
  Eigen::Matrix3d S;
  S << 0.0, -v.z(), v.y(),  //
      v.z(), 0.0, -v.x(),   //
      -v.y(), v.x(), 0.0;
  return S;
}

}  // namespace limpet
