// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// Where a vehicle is, from NAV_X, NAV_Y, NAV_HEADING, NAV_SPEED, NAV_DEPTH and NAV_ALTITUDE: all
/// that vehicles without pNav say.
class StockNav {
 public:
  enum class Quantity { kX, kY, kHeading, kSpeed, kDepth, kAltitude };

  /// `value` as MOOS has it: metres, degrees clockwise from north, m/s.
  void Hear(Quantity quantity, double value, Seconds now) {
    heard_.at(static_cast<std::size_t>(quantity)) = Stamped<double>{now, value};
  }
  /// True if all that is needed was ever heard; depth only if `needs_depth`.
  [[nodiscard]] bool IsComplete(bool needs_depth) const;
  /// The state, of which nothing is older than `grace`; the speed is taken to be ahead, depth to be
  /// 0 where nobody says it. An altitude that is older is left out.
  [[nodiscard]] std::optional<NavState> At(Seconds now, Seconds grace, bool needs_depth) const;

 private:
  [[nodiscard]] const std::optional<Stamped<double>>& Of(Quantity quantity) const {
    return heard_.at(static_cast<std::size_t>(quantity));
  }
  std::array<std::optional<Stamped<double>>, 6> heard_;
};

}  // namespace limpet
