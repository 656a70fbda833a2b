// SPDX-License-Identifier: MIT
#include "limpet/app/registry.hpp"

#include <algorithm>
#include <iterator>

#include "limpet/app/app_caster.hpp"
#include "limpet/app/app_tick.hpp"

namespace limpet {

std::map<std::string, AppEntry>& AppRegistry() {
  static std::map<std::string, AppEntry> registry;
  return registry;
}

std::vector<ConfigProblem> CheckCommonAppKeys(const ConfigBlock& block) {
  std::vector<ConfigProblem> problems;
  const auto collect = [&problems](const auto& read) {
    try {
      static_cast<void>(read());
    } catch (const ConfigError& error) {
      std::ranges::copy(error.problems(), std::back_inserter(problems));
    }
  };
  collect([&block] { return AppTickRate(block, 1.0); });
  collect([&block] { return ReadCastSettings(block); });
  return problems;
}

}  // namespace limpet
