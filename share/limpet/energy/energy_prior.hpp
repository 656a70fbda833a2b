// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/vehicle/battery_sheet.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// What is believed of a vehicle's energy before anything was used: its sheets, with a margin.
struct EnergyPrior {
  MetersPerSecond cruise;    ///< half of the top speed
  double metre_wh = 0.0;     ///< a metre of way, at that speed
  double idle_w = 0.0;       ///< without way on
  double capacity_wh = 0.0;  ///< of a full battery

  [[nodiscard]] static EnergyPrior Of(const VehicleParams& vehicle, const BatterySheet& battery);
};

}  // namespace limpet
