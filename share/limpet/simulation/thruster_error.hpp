// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"

namespace limpet {

/// How the thrusters differ from the vehicle's file: fouled propellers, a low battery.
struct ThrusterErrorParams {
  double thrust_factor = 1.0;
  double saturates_at = 1.0;
  double lag_factor = 1.0;

  template <class V>
  void Describe(V& visit) {
    visit("thrust_factor", thrust_factor, "Thrust at a command, over what the file says",
          InRange(0.05, 3.0));
    visit("saturates_at", saturates_at, "Command beyond which the thrust grows no more, either way",
          InRange(0.05, 1.0));
    visit("lag_factor", lag_factor, "Lag from command to thrust, over what the file says",
          InRange(0.1, 20.0));
  }
};

}  // namespace limpet
