// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <Eigen/Core>

#include "limpet/mission/scenario.hpp"

namespace limpet {

/// The true seabed with its coefficients worked out once: a sloping plane plus a relief of zero
/// mean, the sum of sinusoids with wavelengths of 1 to 8 m drawn from the scenario's seed. About
/// 30 ns a point, no allocation, safe to share between threads. SeabedDepth() is the same surface
/// at some thirty times that cost.
class Seabed {
 public:
  explicit Seabed(const Scenario::Seabed& scenario);
  /// NED depth [m] at (north, east) [m].
  [[nodiscard]] double Depth(const Eigen::Vector2d& p_W) const;

 private:
  static constexpr std::size_t kWaves = 12;
  double depth_;
  double slope_north_;
  double slope_east_;
  double amplitude_;
  std::array<double, kWaves> turns_north_{};  ///< wave numbers [turns/m]
  std::array<double, kWaves> turns_east_{};
  std::array<double, kWaves> phase_{};  ///< [turns]
};

}  // namespace limpet
