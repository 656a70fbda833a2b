// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Times of trouble that come at random, each of a random length.
class RandomIntervals {
 public:
  struct Params {
    double per_second = 0.0;  ///< on average, from the end of one to the start of the next
    Seconds shortest{0.0}, longest{0.0};
  };
  explicit RandomIntervals(const Params& params) : params_(params) {}

  /// Whether `now` lies in one; it does not go back.
  [[nodiscard]] bool Contain(Seconds now, Random& random) {
    if (params_.per_second <= 0.0) return false;
    if (!next_) next_ = now + Waiting(random);
    while (*next_ <= now) {
      until_ = *next_ + Seconds(random.Uniform(params_.shortest.value(), params_.longest.value()));
      next_ = until_ + Waiting(random);
      ++count_;
    }
    return now < until_;
  }
  /// How many have begun.
  [[nodiscard]] int count() const { return count_; }

 private:
  [[nodiscard]] Seconds Waiting(Random& random) const {
    return Seconds(-std::log(1.0 - random.Uniform(0.0, 1.0)) / params_.per_second);
  }

  Params params_;
  std::optional<Seconds> next_;
  Seconds until_{0.0};
  int count_ = 0;
};

}  // namespace limpet
