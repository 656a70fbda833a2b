// SPDX-License-Identifier: MIT
// What a mission's text may reach: it comes from elsewhere, and the one who launches it has not
// read every line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// Environment variable by which a launcher with --allow-outside tells its processes.
inline constexpr const char* kAllowOutside = "LIMPET_ALLOW_OUTSIDE";

/// True if `path`, taken from `base` if relative, lies in one of the folders or below, after `..`
/// and symbolic links are resolved. What does not exist yet is judged by its nearest existing
/// parent.
[[nodiscard]] bool LiesInside(const std::filesystem::path& path, const std::filesystem::path& base,
                              const std::vector<std::filesystem::path>& folders);

/// Why `name` cannot be the name of a process and thus of its log, or nothing.
[[nodiscard]] std::optional<std::string> ProcessNameProblem(std::string_view name);

/// Where the mission's loggers would write outside of `folders` (relative paths start at the
/// working directory): GlobalLogPath, and Path, File and LoggingDirectorySummaryFile of pLog and
/// pLogger.
[[nodiscard]] std::vector<ConfigProblem> OutsideProblems(
    const MissionFile& mission, const std::vector<std::filesystem::path>& folders);

}  // namespace limpet
