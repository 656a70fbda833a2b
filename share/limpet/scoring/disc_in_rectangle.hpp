// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// Share of a disc that lies inside the rectangle |x| <= half_size.x, |y| <= half_size.y; 0 to 1,
/// exact. REQUIRES: radius > 0.
[[nodiscard]] double ShareOfDiscInRectangle(const Eigen::Vector2d& center, double radius,
                                            const Eigen::Vector2d& half_size);

}  // namespace limpet
