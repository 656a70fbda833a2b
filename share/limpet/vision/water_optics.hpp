// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace limpet {

/// Share of a contrast that is left at the visibility.
inline constexpr double kContrastAtVisibility = 0.05;
/// Share of its light below which no 8-bit image shows a thing: beyond twice the visibility.
inline constexpr double kLeastTransmission = 0.002;

/// How water dims and veils what lies behind it: I = J exp(-c d) + A (1 - exp(-c d)) per channel,
/// linear light. The visibility is the distance at which the clearest channel, green, keeps 5 % of
/// a contrast; red fades faster by the absorption of water itself.
struct WaterOptics {
  std::array<double, 3> attenuation_per_m{};            ///< c; blue, green, red [1/m]
  std::array<double, 3> veil{0.22, 0.26, 0.09};         ///< A; blue, green, red
  std::array<double, 3> illumination{0.95, 1.1, 1.05};  ///< of a surface that faces up

  /// REQUIRES: visibility_m > 0.
  [[nodiscard]] static WaterOptics OfVisibility(double visibility_m);
};

}  // namespace limpet
