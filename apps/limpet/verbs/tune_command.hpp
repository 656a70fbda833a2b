// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/limpet/cli.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/sweeps/sweep.hpp"
#include "limpet/tuning/report_expression.hpp"
#include "limpet/tuning/tuning_report.hpp"

namespace limpet {

/// A search as the command asks for it.
struct TuneCommand {
  TuningTask task{};
  ParameterSpace space{{}};
  ReportExpression objective;
  std::vector<ReportExpression> constraints{};
  SweepPlan plan{};
  std::vector<std::string> settings{};  ///< of `--set` and its kin, for every run
};

/// Throws UsageError; ConfigError of what is varied and is not there.
[[nodiscard]] TuneCommand ReadTuneCommand(const Arguments& given);

/// The mission with the command's settings, and more of them on top.
[[nodiscard]] MissionFile MissionWith(const TuneCommand& command,
                                      const std::vector<std::string>& more);

/// What the mission says today. Throws ConfigError.
[[nodiscard]] SettingValues DefaultOf(const TuneCommand& command);

}  // namespace limpet
