// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace limpet {

/// A closed interval of one coordinate; empty if high < low.
struct Interval {
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] bool is_empty() const { return high < low; }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
  /// The point of it that is nearest to `at`. REQUIRES: not empty.
  [[nodiscard]] double Nearest(double at) const { return std::clamp(at, low, high); }
  /// `inset` shorter at both ends, or its middle if nothing would be left.
  [[nodiscard]] Interval DrawnIn(double inset) const {
    return {std::min(low + inset, middle()), std::max(high - inset, middle())};
  }
  void Cut(const Interval& other) {
    low = std::max(low, other.low);
    high = std::min(high, other.high);
  }
};

}  // namespace limpet
