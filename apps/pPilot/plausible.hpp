// SPDX-License-Identifier: MIT
// What the pilot believes of its mail. Beyond these bounds a number is a fault of its sender, never
// a wish or a place: it counts as not heard.
#pragma once

#include "limpet/topics/navigation.hpp"

namespace limpet {

/// Range [low, high] that a number must lie within; NaN does not.
struct PlausibleRange {
  double low = 0.0, high = 0.0;
  [[nodiscard]] bool Has(double value) const { return value >= low && value <= high; }
};

inline constexpr PlausibleRange kPlausibleHeading{-360.0, 720.0};     // [deg]
inline constexpr PlausibleRange kPlausibleSpeed{-10.0, 10.0};         // [m/s]
inline constexpr PlausibleRange kPlausibleDepth{-10.0, 11'000.0};     // [m]
inline constexpr PlausibleRange kPlausibleTurnRate{-6.2832, 6.2832};  // [rad/s]

/// What the control laws use of it is finite and fit for a vehicle under water.
[[nodiscard]] bool IsPlausible(const NavState& nav);

}  // namespace limpet
