// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace limpet {

/// The middle value, of two the greater. REQUIRES: there is one, and all are numbers.
template <class Value>
[[nodiscard]] Value UpperMedian(std::vector<Value> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// The value that a share of them, in [0, 1], does not exceed, none in between two: of two middle
/// ones the lesser. 0 of none. REQUIRES: `sorted` ascending.
[[nodiscard]] inline double QuantileOfSorted(std::span<const double> sorted, double share) {
  if (sorted.empty()) return 0.0;
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}
/// The same of values in any order. REQUIRES: all are numbers.
[[nodiscard]] inline double Quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return QuantileOfSorted(values, share);
}

}  // namespace limpet
