// SPDX-License-Identifier: MIT
#include "limpet/mission/mission_places.hpp"

#include <algorithm>
#include <filesystem>

namespace limpet {

std::string ProgramOfBlock(const ConfigBlock& block, const MissionFile& mission) {
  const auto launch = std::ranges::find_if(mission.launches, [&block](const LaunchEntry& entry) {
    return EqualsIgnoringCase(entry.moos_name, block.name);
  });
  return launch == mission.launches.end()
             ? block.name
             : std::filesystem::path(launch->binary).filename().string();
}

SourceLine LineOfGlobal(const MissionFile& mission, std::string_view key) {
  for (const ConfigEntry& global : mission.globals) {
    if (EqualsIgnoringCase(global.key, key)) return global.where;
  }
  return {.file = mission.file, .line = 0};
}

}  // namespace limpet
