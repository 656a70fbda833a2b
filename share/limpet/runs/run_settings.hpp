// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/scoring/report_settings.hpp"

namespace limpet {

/// The folder that a command names, without a slash at its end.
[[nodiscard]] std::filesystem::path MissionFolder(const std::string& word);
/// What a mission is called: its folder's own name, also where the command says `.`.
[[nodiscard]] std::string MissionName(const std::filesystem::path& folder);

/// What a report has to know of how a mission was flown, but for its name, seed and command.
/// Throws ConfigError.
[[nodiscard]] ReportSettings SettingsOf(const MissionFile& mission, const Scenario& scenario);

}  // namespace limpet
