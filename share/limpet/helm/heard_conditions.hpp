// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "limpet/helm/situation.hpp"
#include "limpet/mission/condition.hpp"

namespace limpet {

/// True if all conditions of a behavior's own hold by what has been heard.
[[nodiscard]] bool HoldAll(std::span<Condition> conditions, const VehicleState& state);

}  // namespace limpet
