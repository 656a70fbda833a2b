// SPDX-License-Identifier: MIT
#include "behaviors/BHV_ConstantDepth.hpp"

#include "limpet/helm/registry.hpp"

namespace limpet {

MotionBid BHV_ConstantDepth::Move(const VehicleState& state) {
  static_cast<void>(state);
  const double flat = params_.peakwidth.value();
  return {.course = {},
          .speed = {},
          .depth = Peak{.summit = params_.depth.value(),
                        .flat_half_width = flat,
                        .base_half_width = flat + params_.basewidth.value()},
          .turn_rate = {},
          .warning = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_ConstantDepth);

}  // namespace limpet
