// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace limpet {

/// How often a sensor speaks [s]: the median of its last intervals, to a hundredth of a second, so
/// that stamps that jitter change nothing. Pauses do not count.
class SamplePeriod {
 public:
  /// `usual`: until enough samples have come.
  explicit SamplePeriod(double usual) : value_(usual) { intervals_.fill(usual); }

  void Note(double t) {
    if (last_ && t > *last_ && t - *last_ < kPause) {
      intervals_[next_++ % intervals_.size()] = t - *last_;
      std::array<double, kCount> sorted = intervals_;
      std::ranges::nth_element(sorted, sorted.begin() + kCount / 2);
      value_ = std::max(std::round(sorted[kCount / 2] / kGrain), 1.0) * kGrain;
    }
    last_ = t;
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  static constexpr std::size_t kCount = 9;
  static constexpr double kPause = 4.0;   // [s]
  static constexpr double kGrain = 0.01;  // [s]
  std::array<double, kCount> intervals_{};
  std::size_t next_ = 0;
  std::optional<double> last_;
  double value_;
};

}  // namespace limpet
