// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// How near the vehicle came to each obstacle; empty where there are none.
[[nodiscard]] std::string ObstaclesSentence(const SessionScore& session);

}  // namespace limpet
