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

const std::vector<std::string>& CommonAppKeys() {
  static const std::vector<std::string> keys{"AppTick",
                                             "CommsTick",
                                             "MaxAppTick",
                                             "IterateMode",
                                             "SortMailByTime",
                                             "CatchCommandMessages",
                                             "TERM_REPORT_INTERVAL",
                                             "MAX_APPCAST_EVENTS",
                                             "MAX_APPCAST_RUN_WARNINGS",
                                             "APP_LOGGING",
                                             "COMMS_POLICY",
                                             "DEPRECATED_OK",
                                             "moos_tw_delay_factor"};
  return keys;
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
