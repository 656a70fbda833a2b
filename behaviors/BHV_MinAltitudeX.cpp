// SPDX-License-Identifier: MIT
#include "behaviors/BHV_MinAltitudeX.hpp"

#include <algorithm>
#include <optional>

#include "limpet/core/decimal_text.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/heard_altitude.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
void BHV_MinAltitudeX::Params::Describe(ParamCollector& visit) {
  visit("min_altitude", min_altitude, "Height to leave above the seabed",
        InRange(Meters(0.0), Meters(6000.0)));
  visit("missing_altitude_critical", is_missing_critical,
        "Stop the vehicle while nobody says how high it is");
}

MotionBid BHV_MinAltitudeX::Move(const VehicleState& state) {
  ActList acts;
  MotionBid bid;
  const std::optional<double> altitude = AltitudeOf(state);
  if (!altitude) {
    acts.Post("MIN_ALT_STATUS", std::string("Missing NAV_ALTITUDE info"));
    if (params_.is_missing_critical) acts.Halt("nobody says how high it is above the seabed");
  } else {
    constexpr double kSkirt = 0.1;  // [m] deeper is worth nothing
    const double deepest = std::max(0.0, state.nav.down + *altitude - params_.min_altitude.value());
    acts.Post("MIN_ALT_STATUS", DecimalText(deepest, deepest < 10.0 ? 1 : 0));
    bid.depth = Peak{.summit = 0.5 * deepest,
                     .flat_half_width = 0.5 * deepest,
                     .base_half_width = 0.5 * deepest + kSkirt};
  }
  bid.acts = acts.Take();
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_MinAltitudeX);

}  // namespace limpet
