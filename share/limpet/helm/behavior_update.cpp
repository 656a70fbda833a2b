// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_update.hpp"

#include <algorithm>
#include <array>

#include "limpet/core/letter_case.hpp"

namespace limpet {

BehaviorUpdate ParseUpdate(std::string_view text, const std::string& variable) {
  BehaviorUpdate update;
  for (const std::string& part : Split(text, '#')) {
    const std::size_t equals = part.find('=');
    const std::string key(Trim(std::string_view(part).substr(0, equals)));
    const std::string value(
        equals == std::string::npos ? "" : Trim(std::string_view(part).substr(equals + 1)));
    if (EqualsIgnoringCase(key, "name")) {
      update.name = value;
    } else if (!key.empty() || !value.empty()) {
      update.parts.push_back({key, value, {.file = variable, .line = 0}});
    }
  }
  return update;
}

bool MayRepeat(std::string_view text) {
  constexpr std::array<std::string_view, 3> kWords{"toggle", "engage", "mod"};
  const std::string lower = LowerCase(text);
  return std::ranges::any_of(
      kWords, [&lower](std::string_view word) { return lower.find(word) != std::string::npos; });
}

void PutInto(ConfigBlock& block, const ConfigEntry& part, bool is_repeatable) {
  if (!is_repeatable) {
    std::erase_if(block.entries, [&part](const ConfigEntry& entry) {
      return EqualsIgnoringCase(entry.key, part.key);
    });
  }
  block.entries.push_back(part);
}

}  // namespace limpet
