// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/topics/navigation.hpp"

namespace limpet {

/// How the water moves and where it sets to, by the vehicle's own account, for people.
[[nodiscard]] std::string CurrentSentence(const WaterCurrent& current);

}  // namespace limpet
