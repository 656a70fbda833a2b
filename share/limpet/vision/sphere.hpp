// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <Eigen/Core>

namespace limpet {

/// A coloured ball, resting or floating.
struct Sphere {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< centre, NED [m]
  double radius = 0.5;                            ///< [m]
  std::string color;                              ///< a name of `color_table.hpp`
};

}  // namespace limpet
