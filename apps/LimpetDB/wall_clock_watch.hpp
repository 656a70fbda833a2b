// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/core/units.hpp"

namespace limpet {

/// Looks at the wall clock beside vehicle time: what the database says of it (WALL_CLOCK), now and
/// then and when somebody has set it. Times are real ones.
class WallClockWatch {
 public:
  /// They part by more than this only when the wall clock was set.
  static constexpr Seconds kNoticed{0.5};
  static constexpr Seconds kPeriod{60.0};

  struct News {
    std::string record;  ///< of WALL_CLOCK
    /// CLOCK_STEPPED, to be raised with this text; or nothing: all is well (again).
    std::optional<std::string> warning;
  };
  /// Nothing if there is nothing new to say. `vehicle` and `wall`: the clocks, read together.
  [[nodiscard]] std::optional<News> Look(Seconds vehicle, Seconds wall);

 private:
  std::optional<Seconds> told_;  ///< vehicle time of the last word
  Seconds told_ahead_;
  int steps_ = 0;
};

}  // namespace limpet
