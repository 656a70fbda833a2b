// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "estimation/replay/sensor_stream.hpp"

namespace limpet {

/// The depth's rate around times that rise.
class DepthRates {
 public:
  explicit DepthRates(const std::vector<DepthReading>& depths) : depths_(depths) {}
  /// Nothing where samples do not lie over most of the window.
  [[nodiscard]] std::optional<double> At(double t) {
    while (begin_ < depths_.size() && depths_[begin_].t < t - 0.5 * kWindow)
      ++begin_;
    end_ = std::max(begin_, end_);
    while (end_ < depths_.size() && depths_[end_].t <= t + 0.5 * kWindow)
      ++end_;
    if (end_ - begin_ < 2) return std::nullopt;
    const double span = depths_[end_ - 1].t - depths_[begin_].t;
    if (!(span >= 0.75 * kWindow)) return std::nullopt;
    return (depths_[end_ - 1].depth - depths_[begin_].depth) / span;
  }

 private:
  static constexpr double kWindow = 2.0;  ///< [s]
  const std::vector<DepthReading>& depths_;
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace limpet
