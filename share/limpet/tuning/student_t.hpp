// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace limpet {

/// P(T <= t) of Student's t with `degrees` of freedom. REQUIRES: degrees > 0.
[[nodiscard]] double StudentProbability(double t, double degrees);
/// The t with P(T <= t) = p. REQUIRES: 0 < p < 1, degrees > 0.
[[nodiscard]] double StudentQuantile(double p, double degrees);

/// A mean with its two-sided 95 % interval by Student's t. One value alone has no interval.
struct MeanInterval {
  double mean = 0.0;
  std::optional<double> low, high;
  std::size_t count = 0;
  double standard_error = 0.0;  ///< 0 of one value
};
/// REQUIRES: values.
[[nodiscard]] MeanInterval IntervalOf(const std::vector<double>& values);

/// How likely so great a mean of `differences` or a greater one is, if the true mean were 0 (paired
/// t-test, one-sided). 0 or 1 if all differences are alike, 0.5 if they are 0; nothing of fewer
/// than two.
[[nodiscard]] std::optional<double> ChanceOfSoGreatAMean(const std::vector<double>& differences);

}  // namespace limpet
