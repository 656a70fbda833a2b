// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

namespace limpet {

/// Samples of one quantity, in order of time [s].
class ScalarHistory {
 public:
  struct Sample {
    double t, value;
  };
  [[nodiscard]] bool IsNewest(double t) const { return samples_.empty() || t > samples_.back().t; }
  /// REQUIRES: IsNewest(sample.t).
  void Add(const Sample& sample) { samples_.push_back(sample); }
  void DropBefore(double t);

  [[nodiscard]] const std::deque<Sample>& samples() const { return samples_; }
  [[nodiscard]] std::optional<double> last_time() const;
  /// The sample nearest to `t`, the earlier of two as near.
  [[nodiscard]] std::optional<Sample> Nearest(double t) const;
  /// Slope of a line through the samples of the last `span` seconds; nothing from less than four.
  [[nodiscard]] std::optional<double> Slope(double span) const;

 private:
  std::deque<Sample> samples_;
};

}  // namespace limpet
