// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/energy_record.hpp"

namespace limpet {

/// What was used and what is left, by the vehicle's own account, for people.
[[nodiscard]] std::string EnergySentence(const EnergyRecord& energy);

}  // namespace limpet
