// SPDX-License-Identifier: MIT
// Which programs a mission's text may start.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// The option of a `Run` line (case ignored), or nullptr.
[[nodiscard]] const ConfigEntry* OptionOf(const LaunchEntry& entry, std::string_view name);

/// The folder that `Path` of the line, or ExecutablePath of the block, names; nothing for SYSTEM.
/// Relative ones start at the mission's folder, as the mission's other paths do.
[[nodiscard]] std::optional<std::filesystem::path> ProgramFolder(const LaunchEntry& entry,
                                                                 const MissionFile& mission);

/// Why this line may not be started unless --allow-outside is given, or nothing. Allowed are
/// programs by name alone, found beside the launcher or on PATH, whose name is one of a MOOS
/// process: p, i or u and a capital letter. A shell or an interpreter would take the mission file
/// for its script.
[[nodiscard]] std::optional<ConfigProblem> ProgramProblem(const LaunchEntry& entry,
                                                          const MissionFile& mission,
                                                          const std::filesystem::path& own_folder);

/// Why a mission may not give its process these arguments unless --allow-outside is given, or
/// nothing: where the run lies is the launcher's to say.
[[nodiscard]] std::optional<std::string> ArgumentProblem(const std::vector<std::string>& args);

/// The program as a file that may be executed: in `named` if given, beside the launcher, on PATH.
[[nodiscard]] std::optional<std::filesystem::path> FindProgram(
    const std::string& binary, const std::optional<std::filesystem::path>& named,
    const std::filesystem::path& own_folder);

/// True if the mission can do without: viewers, and tools (u...) that are no simulators.
[[nodiscard]] bool IsDispensable(std::string_view binary);

}  // namespace limpet
