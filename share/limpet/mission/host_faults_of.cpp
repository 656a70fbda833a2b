// SPDX-License-Identifier: MIT
#include "limpet/mission/host_faults_of.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/mission/scenario.hpp"
#include "limpet/mission/scenario_place.hpp"

namespace limpet {
namespace {

bool IsMadeByHost(const ScenarioFault& fault) {
  const FaultKind* kind = FindFaultKind(fault.what);
  return kind != nullptr && kind->made_by == kMadeByHost;
}

}  // namespace

std::vector<ScenarioFault> HostFaultsOf(const MissionFile& mission,
                                        const std::filesystem::path& folder,
                                        const std::vector<std::string>& apps) {
  const std::filesystem::path file = ScenarioFileOf(mission, folder);
  if (!std::filesystem::exists(file)) return {};
  std::vector<ScenarioFault> faults = LoadScenario(file).faults;
  std::erase_if(faults, [](const ScenarioFault& fault) { return !IsMadeByHost(fault); });
  for (const ScenarioFault& fault : faults) {
    if (!fault.app.empty() && std::ranges::find(apps, fault.app) == apps.end()) {
      throw ConfigError({{.file = file.string(), .line = 0},
                         "faults",
                         fmt::format("the mission launches no `{}`; nearest: `{}`", fault.app,
                                     NearestWord(fault.app, apps))});
    }
  }
  return faults;
}

}  // namespace limpet
