// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/units.hpp"

namespace limpet {

/// How far images are to be drawn in on every side [m], so that the seam between two that then just
/// meet stays unseen by no more than `loss` on average, when their distance is off by a normal
/// error of 1-sigma `beside`. Images whose places are that well known stay as they are: 0.
[[nodiscard]] double SeamAllowance(Meters beside, Meters loss);
/// However little is known, no image is drawn in by more [m].
inline constexpr double kMostSeamAllowance = 0.6;

}  // namespace limpet
