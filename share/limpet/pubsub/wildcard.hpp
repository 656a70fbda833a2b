// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "limpet/core/units.hpp"

namespace limpet {

/// Minimum time between deliveries, and which variables; `*` any run, `?` one character,
/// case-sensitive.
struct WildcardFilter {
  std::string app_pattern = "*";
  std::string variable_pattern = "*";
  Seconds interval;
};

/// True if the whole `text` matches `pattern`.
[[nodiscard]] bool MatchesWildcard(std::string_view pattern, std::string_view text);

}  // namespace limpet
