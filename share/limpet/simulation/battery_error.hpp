// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"

namespace limpet {

/// How the battery differs from the vehicle's file: aged, not charged, or more draws on it.
struct BatteryErrorParams {
  double charge = 1.0;
  double capacity_factor = 1.0;
  double resistance_factor = 1.0;
  double hotel_factor = 1.0;
  double thrust_power_factor = 1.0;
  double gauge_off = 0.0;

  template <class V>
  void Describe(V& visit) {
    visit("charge", charge, "At the start, share of a full one", InRange(0.0, 1.0));
    visit("capacity_factor", capacity_factor, "Energy of a full one, over what the file says",
          InRange(0.01, 2.0));
    visit("resistance_factor", resistance_factor, "Internal resistance, over what the file says",
          InRange(0.0, 50.0));
    visit("hotel_factor", hotel_factor, "Drawn by all but the thrusters, over what the file says",
          InRange(0.0, 20.0));
    visit("thrust_power_factor", thrust_power_factor,
          "Drawn by a thruster, over what the file says", InRange(0.05, 20.0));
    visit("gauge_off", gauge_off, "The gauge says so much more charge than there is",
          InRange(-1.0, 1.0));
  }
};

}  // namespace limpet
