// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/safety/safety_ladder.hpp"

namespace limpet {

/// The table of safety rules with the limits that a mission gives them, for a terminal.
[[nodiscard]] std::string SafetyRulesText(const SafetySettings& settings);
/// The page docs/safety.md.
[[nodiscard]] std::string SafetyRulesMarkdown();

}  // namespace limpet
