// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// What the water let the vehicle see, by its own account, for people.
[[nodiscard]] std::string WaterSentence(const WaterScore& water);

}  // namespace limpet
