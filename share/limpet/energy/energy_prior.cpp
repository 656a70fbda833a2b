// SPDX-License-Identifier: MIT
#include "limpet/energy/energy_prior.hpp"

#include <algorithm>

#include "limpet/energy/way_power.hpp"

namespace limpet {
namespace {

constexpr double kDearer = 1.25;   ///< what is drawn is taken for so much more than the sheets say
constexpr double kSmaller = 0.85;  ///< and the battery for so much of what its sheet says

}  // namespace

EnergyPrior EnergyPrior::Of(const VehicleParams& vehicle, const BatterySheet& battery) {
  const MetersPerSecond cruise = 0.5 * vehicle.top_speed;
  const WayPower power(vehicle, battery);
  const auto thrusters = static_cast<double>(vehicle.thrusters.thrusters.size());
  const double cruise_w =
      std::min(power.Cruising(cruise), battery.hotel_w + thrusters * battery.full_thrust_w);
  return {.cruise = cruise,
          .metre_wh = kDearer * cruise_w / cruise.value() / kJoulesPerWh,
          .idle_w = power.AtRest() + (kDearer - 1.0) * battery.hotel_w,
          .capacity_wh = kSmaller * battery.capacity_wh};
}

}  // namespace limpet
