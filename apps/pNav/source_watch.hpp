// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// How long ago one sensor last gave something good, in vehicle time.
class SourceWatch {
 public:
  /// When a sample was measured, and when it came [s].
  struct Times {
    double stamp = 0.0, now = 0.0;
  };
  /// A good sample has come.
  void Note(const Times& of) {
    last_ = std::max(last_.value_or(of.stamp), std::min(of.stamp, of.now));
  }

  [[nodiscard]] std::optional<double> Age(double now) const {
    return last_ ? std::optional<double>(std::max(now - *last_, 0.0)) : std::nullopt;
  }
  [[nodiscard]] bool IsFresh(double now, Seconds longest) const {
    return last_ && now - *last_ <= longest.value();
  }
  [[nodiscard]] bool was_heard() const { return last_.has_value(); }
  /// State of the source at `now`, its age to the millisecond, as NAV_STATE says it.
  [[nodiscard]] NavSource At(double now, Seconds longest) const {
    const std::optional<double> age = Age(now);
    return {.age = age ? std::optional<double>(std::round(1e3 * *age) / 1e3) : std::nullopt,
            .is_valid = IsFresh(now, longest)};
  }

 private:
  std::optional<double> last_;  ///< [s]
};

}  // namespace limpet
