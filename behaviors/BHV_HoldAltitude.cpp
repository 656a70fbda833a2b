// SPDX-License-Identifier: MIT
#include "behaviors/BHV_HoldAltitude.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/helm/registry.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {
namespace {

const WarningId kAltitudeLost = DeclareWarning(
    "ALTITUDE_LOST",
    {.severity = Severity::kWarning,
     .raised_by = {"BHV_HoldAltitude"},
     .meaning = "There has been no bottom lock for memory_s: the behavior has no say on the depth.",
     .action =
         "See DVL_NO_LOCK of pNav; where no other behavior wants a depth, the helm stops all.",
     .clears = "With the next altitude, or once the behavior does not run."});

}  // namespace

void BHV_HoldAltitude::Start(const VehicleState& state) {
  seabed_down_.reset();
  seen_at_ = state.now;
}

void BHV_HoldAltitude::TrackSeabed(const VehicleState& state) {
  if (!state.nav.altitude) {
    return;
  }
  const double measured = state.nav.down + *state.nav.altitude;
  const double elapsed = (state.now - seen_at_).value();
  const double tau = params_.smoothing.value();
  // DVL altitude jumps where a beam meets an object; the average keeps the vehicle from bobbing
  // over it.
  const double share = seabed_down_ && tau > 0.0 ? 1.0 - std::exp(-elapsed / tau) : 1.0;
  seabed_down_ = seabed_down_.value_or(measured) * (1.0 - share) + measured * share;
  seen_at_ = state.now;
}

MotionBid BHV_HoldAltitude::Move(const VehicleState& state) {
  TrackSeabed(state);
  if (!seabed_down_ || state.now - seen_at_ > params_.memory) {
    return {.course = {},
            .speed = {},
            .depth = {},
            .turn_rate = {},
            .warning = BehaviorWarning{kAltitudeLost, "no bottom lock"}};
  }
  const double summit = std::max(*seabed_down_ - params_.altitude.value(), 0.0);
  const double flat = params_.tolerance.value();
  return {.course = {},
          .speed = {},
          .depth = Peak{.summit = summit,
                        .flat_half_width = flat,
                        .base_half_width = flat + params_.skirt.value()},
          .turn_rate = {},
          .warning = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_HoldAltitude);

}  // namespace limpet
