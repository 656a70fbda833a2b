// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/pubsub/wildcard.hpp"

namespace limpet {

/// True if the whole `text` matches one of them; nothing matches none.
[[nodiscard]] inline bool MatchesAny(const std::vector<std::string>& patterns,
                                     std::string_view text) {
  return std::ranges::any_of(
      patterns, [text](const std::string& pattern) { return MatchesWildcard(pattern, text); });
}

/// Whether `text` is chosen by patterns that leave nothing out unless they name something.
[[nodiscard]] inline bool IsChosen(const std::vector<std::string>& patterns,
                                   std::string_view text) {
  return patterns.empty() || MatchesAny(patterns, text);
}

}  // namespace limpet
