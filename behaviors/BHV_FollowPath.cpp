// SPDX-License-Identifier: MIT
#include "behaviors/BHV_FollowPath.hpp"

#include "limpet/helm/registry.hpp"

namespace limpet {

MotionBid BHV_FollowPath::Move(const VehicleState& state) {
  if (!state.guidance) {
    return {};
  }
  const double speed = params_.speed.value();
  return {.course = Peak{.summit = state.guidance->course,
                         .flat_half_width = 0.0,
                         .base_half_width = params_.course_skirt.value()},
          .speed = Peak{.summit = speed, .flat_half_width = 0.0, .base_half_width = speed},
          .depth = {},
          .turn_rate = state.guidance->turn_rate,
          .warning = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_FollowPath);

}  // namespace limpet
