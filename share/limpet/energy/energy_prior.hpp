// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/vehicle/battery_sheet.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// Drawn from the battery by a vehicle that goes straight ahead at `speed` through the water and
/// keeps its depth [W]: its drag and its buoyancy, shared by the thrusters that can push that way.
/// Infinite if they cannot push so hard.
[[nodiscard]] double CruisePower(const VehicleParams& vehicle, const BatterySheet& battery,
                                 MetersPerSecond speed);

/// What is believed of a vehicle's energy before anything was used: its sheets, with a margin.
struct EnergyPrior {
  double metre_wh = 0.0;     ///< a metre of way, at half of the top speed
  double idle_w = 0.0;       ///< without way on
  double capacity_wh = 0.0;  ///< of a full battery

  [[nodiscard]] static EnergyPrior Of(const VehicleParams& vehicle, const BatterySheet& battery);
};

}  // namespace limpet
