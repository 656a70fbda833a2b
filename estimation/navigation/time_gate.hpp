// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace limpet {

/// Refuses a sample that leaps ahead in time, unless others agree with it: a corrupt time must not
/// stop the clock for all that follows, but a real gap goes on.
class TimeGate {
 public:
  /// `t`: of the sample, `last`: of the last accepted one [s].
  [[nodiscard]] bool Accepts(double t, double last) {
    if (t - last > kLeap) {
      if (!leaps_.empty() && std::abs(t - leaps_.back()) > kAgreement) leaps_.clear();
      leaps_.push_back(t);
      if (leaps_.size() < kAgreeing) return false;
    }
    leaps_.clear();
    return true;
  }

 private:
  static constexpr double kLeap = 30.0;        // [s] that one sample does not prove
  static constexpr double kAgreement = 1.0;    // [s] between samples that agree
  static constexpr std::size_t kAgreeing = 3;  // samples that prove it
  std::vector<double> leaps_;                  ///< times of samples in a row that leapt ahead
};

/// Refuses measurements off their prediction, but not so many in a row: then the prediction is
/// what is wrong.
class PersistenceGate {
 public:
  explicit PersistenceGate(int believe_after) : believe_after_(believe_after) {}
  [[nodiscard]] bool Accepts(bool is_as_predicted) {
    if (!is_as_predicted && ++refused_ < believe_after_) return false;
    refused_ = 0;
    return true;
  }

 private:
  int believe_after_, refused_ = 0;
};

}  // namespace limpet
