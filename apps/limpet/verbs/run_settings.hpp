// SPDX-License-Identifier: MIT
#pragma once

#include "apps/limpet/report/report_settings.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"

namespace limpet {

/// What a report has to know of how a mission was flown, but for its name, seed and command.
/// Throws ConfigError.
[[nodiscard]] ReportSettings SettingsOf(const MissionFile& mission, const Scenario& scenario);

}  // namespace limpet
