// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "limpet/core/interval.hpp"

namespace limpet {

/// A preference over one decision variable: 1 on the flat top around `summit`, falling linearly to
/// 0 at the base. For courses the distance is the shorter way round.
struct Peak {
  double summit = 0.0;
  double flat_half_width = 0.0;
  double base_half_width = 1.0;  ///< REQUIRES: > flat_half_width
  /// Value at the end of the top: below 1 that is not flat, but falls to there from the summit.
  double edge_value = 1.0;
  /// Share of the behavior's weight that this variable gets; two that are coupled have a part each.
  double share = 1.0;
};

/// Share of a behavior's weight that each variable gets where the behavior couples two.
inline constexpr double kCoupledShare = 0.5;

/// One side of a peak, from its summit on: flat, then falling over the skirt.
struct PeakSide {
  double flat_half_width = 0.0;
  double skirt = 0.0;
};
/// Where that side ends; one without a skirt gets a thin one.
[[nodiscard]] constexpr double BaseBeyond(const PeakSide& side) {
  constexpr double kLeastSkirt = 1e-3;
  return side.flat_half_width + (side.skirt > kLeastSkirt ? side.skirt : kLeastSkirt);
}

struct WeightedPeak {
  Peak peak;
  double weight = 1.0;
};

/// Value of a peak at a distance from its summit, in [0, 1].
[[nodiscard]] double PeakValue(const Peak& peak, double distance);

/// How far beyond a limit `x` is: a peak that is as good from the low end of the domain up to the
/// end of its top sets one there, as safety behaviors do; 0 for other peaks.
[[nodiscard]] double BeyondLimit(const Peak& peak, double x, const Interval& domain);
/// How far beyond the top of a peak `x` is.
[[nodiscard]] double BeyondTop(const Peak& peak, double x);

/// The exact maximiser of the weighted sum over the domain. The sum is piecewise linear, so its
/// maximum is at a summit, a knee or an end of the domain. Among equals wins what is least beyond
/// the limits of others (BeyondLimit), then the nearest to what those want who get nothing (7 m at
/// most, and 50 m wanted: 7 m), then the summit of the heaviest peak. REQUIRES: neither peaks nor
/// domain are empty.
[[nodiscard]] double MaximizeOverInterval(std::span<const WeightedPeak> peaks,
                                          const Interval& domain);

/// The exact maximiser over the circle of a weighted sum of peaks over angles [rad], in (-pi, pi];
/// among equals as MaximizeOverInterval. REQUIRES: !peaks.empty().
[[nodiscard]] double MaximizeOverCircle(std::span<const WeightedPeak> peaks);

}  // namespace limpet
