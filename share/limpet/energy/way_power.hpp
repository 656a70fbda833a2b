// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/topics/energy.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/vehicle/battery_sheet.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// A vehicle's way over ground: along its heading, as the pilot flies.
struct Way {
  double course = 0.0;  ///< [rad]
  MetersPerSecond speed;
};

/// What is drawn from the battery on the way, by the data sheets: hotel load, drag and buoyancy,
/// each force shared evenly by the thrusters that can push that way [W]. Infinite where they cannot
/// push so hard.
class WayPower {
 public:
  WayPower(const VehicleParams& vehicle, const BatterySheet& battery);

  /// Straight ahead at `speed` through the water, at constant depth.
  [[nodiscard]] double Cruising(MetersPerSecond speed) const;
  [[nodiscard]] double AtRest() const;
  /// On `way`, held against what the current does ahead and abeam.
  [[nodiscard]] double In(const WaterCurrent& current, const Way& way) const;
  /// What a metre of `way` takes, in metres of still water; at most kDearest.
  [[nodiscard]] double CostOf(const WaterCurrent& current, const Way& way) const;
  /// What a metre takes on every course at one speed, in metres of still water.
  [[nodiscard]] CourseCost CostsOf(const WaterCurrent& current, MetersPerSecond speed) const;

  static constexpr double kDearest = 10.0;

 private:
  /// With this velocity through the water, body axes [m/s].
  [[nodiscard]] double Through(const Eigen::Vector2d& velocity_B) const;
  /// Thrust of each that together push so hard along an axis [N].
  [[nodiscard]] ThrusterVector ThrustsFor(int axis, double force_n) const;

  BatterySheet battery_;
  Hydrodynamics hydro_;
  ThrusterWrenches wrench_per_thrust_;
  double max_thrust_n_, net_buoyancy_n_;
};

}  // namespace limpet
