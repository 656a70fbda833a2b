// SPDX-License-Identifier: MIT
// Mail that changes a behavior while the helm runs: `speed = 2 # name = survey # pwt = 50`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

struct BehaviorUpdate {
  std::optional<std::string> name;  ///< of the behavior that it is for; absent: all that listen
  std::vector<ConfigEntry> parts;   ///< the rest; their lines name the variable
};

/// Parts stand between `#`; empty ones are left out, those without `=` have an empty value.
[[nodiscard]] BehaviorUpdate ParseUpdate(std::string_view text, const std::string& variable);

/// True for updates that count again though they are the same text as the one before: such as
/// toggle something.
[[nodiscard]] bool MayRepeat(std::string_view text);

/// Puts a part into a block: it replaces all lines of its key, except that flags, conditions and
/// what else `is_repeatable` add one.
void PutInto(ConfigBlock& block, const ConfigEntry& part, bool is_repeatable);

/// What became of an update, in MOOS-IvP's words.
struct UpdateOutcome {
  std::string_view result;  ///< success, param_error, name_mismatch or duplicate
  std::optional<std::string> complaint{};
};

}  // namespace limpet
