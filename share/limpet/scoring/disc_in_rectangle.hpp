// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// Share of a disc that lies inside the rectangle |x| <= half_size_R.x, |y| <= half_size_R.y; 0 to
/// 1, exact. R: the rectangle's middle and sides. REQUIRES: radius > 0.
[[nodiscard]] double ShareOfDiscInRectangle(const Eigen::Vector2d& center_R, double radius,
                                            const Eigen::Vector2d& half_size_R);

}  // namespace limpet
