// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limpet/mission/fault_kinds.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// The faults, of the scenario that the mission's vehicle is simulated by, that no app of it makes
/// but who hosts it: of processes, the wall clock and the disk. None without a scenario. Throws
/// ConfigError where an app is to fail that is not among `apps`, those that are launched.
[[nodiscard]] std::vector<ScenarioFault> HostFaultsOf(const MissionFile& mission,
                                                      const std::filesystem::path& folder,
                                                      const std::vector<std::string>& apps);

}  // namespace limpet
