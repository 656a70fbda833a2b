// SPDX-License-Identifier: MIT
#include "limpet/session/session_name.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

constexpr std::size_t kLongestName = 64;
/// A run folder's own part, and expect.yaml's word for every session.
constexpr std::array<std::string_view, 2> kReservedNames{"figures", "each"};

/// Letters as they are, anything a terminal might obey as a question mark.
std::string Harmless(std::string_view text) {
  std::string shown(text.substr(0, kLongestName));
  std::ranges::replace_if(
      shown, [](char c) { return c < 0x20 || c > 0x7E; }, '?');
  return shown + (text.size() > kLongestName ? "..." : "");
}

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

}  // namespace

std::optional<Error> SessionNameProblem(std::string_view name) {
  constexpr std::string_view kAllowed = "a session's name is 1 to 64 of a-z, 0-9, `_` and `-`";
  if (name.empty()) {
    return Error{fmt::format("an empty word names no session; {}", kAllowed)};
  }
  if (name.size() > kLongestName || !std::ranges::all_of(name, IsNameCharacter)) {
    return Error{fmt::format("`{}` cannot name a session; {}", Harmless(name), kAllowed)};
  }
  if (std::ranges::find(kReservedNames, name) != kReservedNames.end()) {
    return Error{fmt::format("`{}` cannot name a session; the word is Limpet's own", name)};
  }
  return std::nullopt;
}

std::optional<Error> SessionListProblem(const std::vector<std::string>& sessions,
                                        const std::vector<std::string>& known) {
  if (sessions.empty()) {
    return Error{"no session is named"};
  }
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const std::string& name = sessions[i];
    if (auto problem = SessionNameProblem(name)) {
      return problem;
    }
    const auto before = sessions.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(sessions.begin(), before, name) != before) {
      return Error{fmt::format("session `{}` comes twice", name)};
    }
    if (!known.empty() && std::ranges::find(known, name) == known.end()) {
      const std::string nearest = NearestWord(name, known);
      return Error{fmt::format(
          "no session `{}` in the scenario, which has {}{}", name, fmt::join(known, ", "),
          nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest))};
    }
  }
  return std::nullopt;
}

}  // namespace limpet
