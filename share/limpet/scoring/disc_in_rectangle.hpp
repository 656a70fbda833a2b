// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// Share of the disc of `radius` around (x, y) that lies inside the rectangle |x| <= half_width,
/// |y| <= half_height; 0 to 1, exact. REQUIRES: radius > 0.
[[nodiscard]] double ShareOfDiscInRectangle(double x, double y, double radius, double half_width,
                                            double half_height);

}  // namespace limpet
