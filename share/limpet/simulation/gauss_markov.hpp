// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Exponentially correlated noise (first-order Gauss-Markov), stationary from its first value and
/// exact for any spacing of samples.
class GaussMarkov {
 public:
  GaussMarkov(double sigma, Seconds correlation) : sigma_(sigma), correlation_(correlation) {}

  /// The value at `now`, which does not go back.
  double Sample(Seconds now, Random& random) {
    const double keep = last_ ? std::exp(-((now - *last_) / correlation_)) : 0.0;
    value_ = keep * value_ + random.Normal(sigma_ * std::sqrt(1.0 - keep * keep));
    last_ = now;
    return value_;
  }

 private:
  double sigma_;
  Seconds correlation_;
  double value_ = 0.0;
  std::optional<Seconds> last_;
};

}  // namespace limpet
