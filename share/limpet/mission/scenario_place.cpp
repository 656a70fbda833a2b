// SPDX-License-Identifier: MIT
#include "limpet/mission/scenario_place.hpp"

namespace limpet {

std::filesystem::path ScenarioFileOf(const MissionFile& mission,
                                     const std::filesystem::path& mission_folder) {
  const ConfigBlock* block = mission.Block("uSimVehicle");
  const ConfigEntry* line = block != nullptr ? block->Find("scenario") : nullptr;
  return mission_folder / (line != nullptr ? line->value : "scenario.yaml");
}

}  // namespace limpet
