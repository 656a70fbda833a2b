// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "limpet/core/interval.hpp"

namespace limpet {

/// ln p / (1 - p), whose inverse is Logistic. Infinite at 0 and 1, not a number outside [0, 1].
[[nodiscard]] inline double LogOddsOf(double probability) {
  return std::log(probability / (1.0 - probability));
}
/// The log odds of the nearest probability in `credible`: a witness that is surer than that is
/// taken to be no surer. REQUIRES: `credible` not empty.
[[nodiscard]] inline double LogOddsOf(double probability, const Interval& credible) {
  return LogOddsOf(credible.Nearest(probability));
}

/// Density at `z` of the standard normal distribution.
[[nodiscard]] inline double StandardNormalDensity(double z) {
  return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}
/// Chance that a standard normal variable is below `z`. Exact in the lower tail: to about -38.
[[nodiscard]] inline double StandardNormalShareBelow(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}
/// Chance that a normal variable is less than `off` above its mean. REQUIRES: `variance` not
/// negative; 0 over 0 is not a number.
[[nodiscard]] inline double NormalShareBelow(double off, double variance) {
  return 0.5 * std::erfc(-off / std::sqrt(2.0 * variance));
}

/// How far from a normal density's mean: the squared Mahalanobis distance, and ln of the
/// determinant of the covariance that it is counted in.
struct NormalMisfit {
  double distance2 = 0.0;
  double log_determinant = 0.0;
  int dimensions = 1;
};
/// -2 ln of the density there. The argument of the logarithm has the unit of the variables to the
/// power of minus `dimensions`, so costs compare only among variables of one kind.
[[nodiscard]] inline double NormalCost(const NormalMisfit& misfit) {
  return misfit.distance2 + misfit.log_determinant +
         misfit.dimensions * std::log(2.0 * std::numbers::pi);
}

}  // namespace limpet
