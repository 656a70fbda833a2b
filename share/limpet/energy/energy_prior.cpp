// SPDX-License-Identifier: MIT
#include "limpet/energy/energy_prior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {
namespace {

constexpr double kDearer = 1.25;   ///< what is drawn is taken for so much more than the sheets say
constexpr double kSmaller = 0.85;  ///< and the battery for so much of what its sheet says

/// Drawn by the thrusters that share a force along a body axis evenly [W].
double PowerAlong(const VehicleParams& vehicle, const BatterySheet& battery, int axis,
                  double force_n) {
  const auto push = vehicle.thrusters.WrenchPerThrust().row(axis).cwiseAbs();
  const double most_n = vehicle.thrusters.max_thrust_n * push.sum();
  if (force_n > most_n) return std::numeric_limits<double>::infinity();
  double power_w = 0.0;
  for (int i = 0; i < kThrusters; ++i) {
    if (push(i) > 0.0) power_w += battery.ThrusterPower(force_n / most_n);
  }
  return power_w;
}

}  // namespace

double CruisePower(const VehicleParams& vehicle, const BatterySheet& battery,
                   MetersPerSecond speed) {
  const double drag_n = DragForce(DeriveHydrodynamics(vehicle), kSurge, speed.value());
  return battery.hotel_w + PowerAlong(vehicle, battery, kSurge, drag_n) +
         PowerAlong(vehicle, battery, kHeave, vehicle.net_buoyancy_n);
}

EnergyPrior EnergyPrior::Of(const VehicleParams& vehicle, const BatterySheet& battery) {
  const MetersPerSecond cruise = 0.5 * vehicle.top_speed;
  const double cruise_w = std::min(CruisePower(vehicle, battery, cruise),
                                   battery.hotel_w + kThrusters * battery.full_thrust_w);
  return {.metre_wh = kDearer * cruise_w / cruise.value() / kJoulesPerWh,
          .idle_w = kDearer * battery.hotel_w +
                    PowerAlong(vehicle, battery, kHeave, vehicle.net_buoyancy_n),
          .capacity_wh = kSmaller * battery.capacity_wh};
}

}  // namespace limpet
