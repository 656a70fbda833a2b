// SPDX-License-Identifier: MIT
// Decisions of peaks alone over the points of a domain, as MOOS-IvP's helm makes them.
#pragma once

#include <span>

#include "limpet/helm/motion_domain.hpp"
#include "limpet/helm/peak.hpp"

namespace limpet {

/// A peak that is worth nothing at every point stands at the nearest one: narrow ones between two
/// points, and those beyond the domain. Others are left as they are.
[[nodiscard]] Peak StandingAtPoints(const Peak& peak, const MotionAxis& axis,
                                    MotionVariable variable);

/// The point of `axis` where the weighted sum of peaks is largest: every point is looked at. Among
/// equals as MaximizeOverInterval, then the nearest to the heaviest peak's summit, then the lowest.
/// Of speeds and depths that lie in the middle of two best points, and are as good, the value
/// itself: a helm that knows points alone goes to and fro between the two, and so fast on average.
/// Courses [rad] in (-pi, pi]. REQUIRES: !peaks.empty().
[[nodiscard]] double MaximizeOverPoints(std::span<const WeightedPeak> peaks, const MotionAxis& axis,
                                        MotionVariable variable);

}  // namespace limpet
