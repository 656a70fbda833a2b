// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/helm/situation.hpp"

namespace limpet {

/// Height above the seabed [m]: the navigation's, else what NAV_ALTITUDE says; nothing if neither
/// does. Who asks names NAV_ALTITUDE among its `Variables`.
[[nodiscard]] std::optional<double> AltitudeOf(const VehicleState& state);

}  // namespace limpet
