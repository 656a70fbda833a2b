// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// What conventional lanes would have taken, and how much of that this survey did; empty where no
/// lanes were reckoned.
[[nodiscard]] std::string LanesSentence(const SessionScore& session);
/// Whose options were flown, how far; empty where the helm chose none.
[[nodiscard]] std::string WinsSentence(const SessionScore& session);

}  // namespace limpet
