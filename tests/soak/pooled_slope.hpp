// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace limpet {

/// The common slope of many short lines, each with a level of its own: least squares.
class PooledSlope {
 public:
  /// One line: y over x.
  void Add(const std::vector<double>& x, const std::vector<double>& y) {
    double mean_x = 0.0, mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      mean_x += x[i] / static_cast<double>(x.size());
      mean_y += y[i] / static_cast<double>(x.size());
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      xx_ += (x[i] - mean_x) * (x[i] - mean_x);
      xy_ += (x[i] - mean_x) * (y[i] - mean_y);
    }
  }
  /// Absent where nothing says one.
  [[nodiscard]] std::optional<double> value() const {
    return xx_ > 0.0 ? std::optional(xy_ / xx_) : std::nullopt;
  }

 private:
  double xx_ = 0.0, xy_ = 0.0;
};

}  // namespace limpet
