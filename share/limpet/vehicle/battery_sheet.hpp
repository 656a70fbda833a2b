// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"

namespace limpet {

inline constexpr double kJoulesPerWh = 3600.0;

/// What the data sheets say of the battery and of what draws on it. A vehicle's file that has the
/// section `battery` has one; the defaults are of a FeelHippo-class vehicle.
struct BatterySheet {
  bool is_present = false;
  double capacity_wh = 480.0;
  double full_v = 29.4;   ///< open-circuit voltages: seven cells of lithium in series
  double empty_v = 21.0;  ///< below it, under load, its protection switches off
  double resistance_ohm = 0.06;
  double hotel_w = 55.0;
  double full_thrust_w = 90.0;
  double capacity_sigma = 0.05;
  double gauge_sigma = 0.02;

  template <class V>
  void Describe(V& visit) {
    visit("present", is_present, "Whether there is one; a file with this section has one");
    visit("capacity_wh", capacity_wh, "Energy of a full one [Wh]", InRange(1.0, 1e6));
    visit("full_v", full_v, "Open-circuit voltage when full [V]", InRange(1.0, 1000.0));
    visit("empty_v", empty_v,
          "Open-circuit voltage when empty; under load its protection switches off there [V]",
          InRange(0.5, 1000.0));
    visit("resistance_ohm", resistance_ohm, "Internal resistance, cables included [ohm]",
          InRange(0.0, 10.0));
    visit("hotel_w", hotel_w, "Drawn by all but the thrusters [W]", InRange(0.0, 1e5));
    visit("full_thrust_w", full_thrust_w,
          "Drawn by one thruster at full thrust; at a share of it that to the power of 1.5 [W]",
          InRange(0.1, 1e6));
    visit("capacity_sigma", capacity_sigma,
          "1-sigma of the share by which its energy is off: age, temperature", InRange(0.0, 0.5));
    visit("gauge_sigma", gauge_sigma,
          "1-sigma of the charge that its gauge says, constant over a session, share of a full one",
          InRange(0.0, 0.5));
  }

  /// Voltage at rest [V], by charge, the share of a full one (0 to 1): steep at both ends, flat
  /// between, as cells of lithium are.
  [[nodiscard]] double OpenCircuitVolts(double charge) const;
  /// The charge of which that is the voltage.
  [[nodiscard]] double ChargeAt(double open_circuit_v) const;
  /// Drawn by a thruster at normalised thrust -1 to 1 [W]: momentum theory of a propeller that
  /// hardly moves.
  [[nodiscard]] double ThrusterPower(double thrust) const;
};

}  // namespace limpet
