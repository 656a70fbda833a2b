// SPDX-License-Identifier: MIT
// Whose a block of a mission is, and where a mission says something.
#pragma once

#include <string>
#include <string_view>

#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// The program that reads a block: of that name, or launched under it.
[[nodiscard]] std::string ProgramOfBlock(const ConfigBlock& block, const MissionFile& mission);

/// The line of a global (case ignored); the mission's file if it has none.
[[nodiscard]] SourceLine LineOfGlobal(const MissionFile& mission, std::string_view key);

}  // namespace limpet
