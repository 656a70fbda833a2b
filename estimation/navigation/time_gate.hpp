// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "estimation/attitude/time_leap.hpp"

namespace limpet {

/// Refuses a sample that leaps ahead in time, unless others agree with it: a corrupt time must not
/// stop the clock for all that follows, but a real gap goes on.
class TimeGate {
 public:
  /// Times of a sample and of the last accepted one [s].
  struct Times {
    double sample = 0.0, last = 0.0;
  };
  [[nodiscard]] bool Accepts(const Times& times) {
    const double t = times.sample;
    if (t - times.last > kTimeLeap) {
      if (!leaps_.empty() && std::abs(t - leaps_.back()) > kLeapAgreement) leaps_.clear();
      leaps_.push_back(t);
      if (leaps_.size() < std::size_t{kLeapSamples}) return false;
    }
    leaps_.clear();
    return true;
  }

 private:
  std::vector<double> leaps_;  ///< times of samples in a row that leapt ahead
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
