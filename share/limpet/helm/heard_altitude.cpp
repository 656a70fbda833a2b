// SPDX-License-Identifier: MIT
#include "limpet/helm/heard_altitude.hpp"

#include <variant>

namespace limpet {

std::optional<double> AltitudeOf(const VehicleState& state) {
  if (state.nav.altitude) return state.nav.altitude;
  const Stamped<Value>* heard = state.Heard("NAV_ALTITUDE");
  const auto* number = heard == nullptr ? nullptr : std::get_if<double>(&heard->value);
  return number == nullptr || *number <= 0.0 ? std::nullopt : std::optional(*number);
}

}  // namespace limpet
