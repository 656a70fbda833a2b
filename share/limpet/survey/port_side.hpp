// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/cross_product.hpp"

namespace limpet {

/// Cross product of two level vectors with x to the north and y to the east: positive where `b`
/// points to port of `a`, zero where they lie along one line [m^2].
[[nodiscard]] inline double CrossToPort(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return CrossOf(b, a);
}

}  // namespace limpet
