// SPDX-License-Identifier: MIT
#include "behaviors/BHV_HoldStation.hpp"

#include <numbers>

#include "limpet/helm/registry.hpp"

namespace limpet {

MotionBid BHV_HoldStation::Move(const VehicleState& state) {
  return {.course = Peak{.summit = heading_.value_or(state.nav.yaw),
                         .flat_half_width = 0.0,
                         .base_half_width = std::numbers::pi},
          .speed = Peak{.summit = 0.0, .flat_half_width = 0.0, .base_half_width = 0.5},
          .depth = {},
          .turn_rate = 0.0,
          .warning = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_HoldStation);

}  // namespace limpet
