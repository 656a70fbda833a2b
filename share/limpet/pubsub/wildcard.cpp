// SPDX-License-Identifier: MIT
#include "limpet/pubsub/wildcard.hpp"

namespace limpet {

bool MatchesWildcard(std::string_view pattern, std::string_view text) {
  // Greedy with one backtrack point: linear in practice, and no recursion for hostile patterns to
  // exhaust.
  std::size_t p = 0;
  std::size_t t = 0;
  std::size_t star = std::string_view::npos;
  std::size_t resume = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++resume;
    } else {
      return false;
    }
  }
  return pattern.substr(p).find_first_not_of('*') == std::string_view::npos;
}

}  // namespace limpet
