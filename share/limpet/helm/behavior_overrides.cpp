// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_overrides.hpp"

#include <fmt/format.h>

namespace limpet {
namespace {

/// Which behaviors there are, for one who named none of them: behaviors go by their names, and a
/// type is near to none of those.
std::string Suggestion(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = NearestWord(name, known);
  return nearest.empty() ? fmt::format("behaviors: `{}`", fmt::join(known, "`, `"))
                         : fmt::format("nearest behavior: `{}`", nearest);
}

}  // namespace

void ApplyBehaviorSettings(std::vector<BehaviorFile>& files,
                           const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const std::size_t dot = setting.find('.');
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, dot);
    const SourceLine where{.file = "--set " + setting, .line = 0};
    std::vector<std::string> known;
    bool is_found = false;
    for (BehaviorFile& file : files) {
      for (ConfigBlock& block : file.behaviors) {
        known.push_back(BehaviorNameOf(block));
        if (known.back() == name) {
          const std::string key = setting.substr(dot + 1, equals - dot - 1);
          std::erase_if(block.entries,
                        [&key](const ConfigEntry& e) { return EqualsIgnoringCase(e.key, key); });
          block.entries.push_back({key, setting.substr(equals + 1), where});
          is_found = true;
        }
      }
    }
    if (!is_found) {
      throw ConfigError(
          {where, name,
           fmt::format("no app or behavior of this name; {}", Suggestion(name, known))});
    }
  }
}

}  // namespace limpet
