// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

namespace limpet {

/// Mean and standard deviation of numbers as they come.
class Statistics {
 public:
  void Add(double x) {
    ++count_;
    const double from_old = x - mean_;
    mean_ += from_old / static_cast<double>(count_);
    sum_sq_ += from_old * (x - mean_);
  }
  [[nodiscard]] double mean() const { return mean_; }
  [[nodiscard]] double sigma() const { return std::sqrt(sum_sq_ / static_cast<double>(count_)); }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
  double mean_ = 0.0;
  double sum_sq_ = 0.0;
};

}  // namespace limpet
