// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_overrides.hpp"

#include <fmt/format.h>

namespace limpet {

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
      throw ConfigError({where, name,
                         fmt::format("no app or behavior of this name; nearest behavior: `{}`",
                                     NearestWord(name, known))});
    }
  }
}

}  // namespace limpet
