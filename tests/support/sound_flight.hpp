// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/safety_trials/dry_run.hpp"

namespace limpet {

/// A flight that nothing speaks against.
[[nodiscard]] inline DryFlight SoundFlight() {
  DryFlight flight;
  flight.ended = "home";
  flight.duration_s = 900.0;
  flight.energy = FlightEnergy{.used_wh = 20.0, .left_wh = 400.0, .reserve_wh = 60.0};
  return flight;
}

}  // namespace limpet
