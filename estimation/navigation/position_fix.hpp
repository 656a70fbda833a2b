// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// A horizontal fix in W with its 1-sigma [m].
struct PositionFix {
  double t = 0.0;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double sd = 0.0;
};

}  // namespace limpet
