// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "limpet/core/statistics.hpp"

namespace limpet {

/// When samples came.
struct SampleTimes {
  std::size_t count = 0, untimely = 0;  ///< untimely: not later than the one before
  double first = 0.0, last = 0.0;       ///< [s]
  double longest_pause = 0.0;           ///< between two [s]

  /// Rate between the first and the last [Hz]; 0 of fewer than two.
  [[nodiscard]] double Rate() const {
    return last > first ? static_cast<double>(count - 1) / (last - first) : 0.0;
  }
};

/// Figures of the lengths of differences.
struct Differences {
  std::size_t count = 0;
  double median = 0.0, within_95 = 0.0, greatest = 0.0;  ///< within_95: 95 % of them
};

/// REQUIRES: there is one. A sample has its time as `t` [s].
template <class Sample>
[[nodiscard]] SampleTimes TimesOf(const std::vector<Sample>& samples) {
  SampleTimes times{.count = samples.size(),
                    .untimely = 0,
                    .first = samples.front().t,
                    .last = samples.front().t,
                    .longest_pause = 0.0};
  for (const Sample& sample : std::span(samples).subspan(1)) {
    const double step = sample.t - times.last;
    if (step <= 0.0) ++times.untimely;
    times.longest_pause = std::max(times.longest_pause, step);
    times.last = std::max(times.last, sample.t);
  }
  return times;
}

[[nodiscard]] inline Differences DifferencesOf(std::vector<double> lengths) {
  if (lengths.empty()) return {};
  std::ranges::sort(lengths);
  return {.count = lengths.size(),
          .median = QuantileOfSorted(lengths, 0.5),
          .within_95 = QuantileOfSorted(lengths, 0.95),
          .greatest = lengths.back()};
}

}  // namespace limpet
