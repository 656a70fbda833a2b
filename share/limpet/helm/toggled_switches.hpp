// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/config.hpp"

namespace limpet {

/// What `part` stands for where `block`, a behavior's, is in force: `toggle`, as MOOS-IvP has it,
/// is the other value of a switch than the present one. Other parts stand for themselves.
[[nodiscard]] ConfigEntry WithoutToggle(const ConfigEntry& part, const ConfigBlock& block);

/// A behavior's block with `true` or `false` for every `toggle`: the other value than a line above
/// it says, or than the default.
[[nodiscard]] ConfigBlock WithoutToggles(ConfigBlock block);

}  // namespace limpet
