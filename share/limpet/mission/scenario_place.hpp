// SPDX-License-Identifier: MIT
// Where the truth of a mission is: one answer for the simulator, the scorer and every check.
#pragma once

#include <filesystem>

#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// What `scenario` of uSimVehicle says, from the mission's folder on; scenario.yaml beside the
/// mission where it says nothing.
[[nodiscard]] std::filesystem::path ScenarioFileOf(const MissionFile& mission,
                                                   const std::filesystem::path& mission_folder);

}  // namespace limpet
