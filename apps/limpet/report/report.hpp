// SPDX-License-Identifier: MIT
// What a run leaves for people and programs: report.json, figures/*.svg, report.html.
#pragma once

#include <filesystem>
#include <vector>

#include "apps/limpet/report/report_settings.hpp"
#include "apps/limpet/report/scorer.hpp"
#include "apps/limpet/report/session_record.hpp"
#include "limpet/mission/scenario.hpp"

namespace limpet {

/// Writes `<out>/run.json`, from which `limpet report` can make a report again. Call it before the
/// run, so that an interrupted run can be reported too.
void WriteRunDescription(const ReportSettings& settings, const Scenario& scenario,
                         const std::filesystem::path& out);

/// Scores the sessions and writes report.json, figures/*.svg and report.html to `out`. Throws
/// std::runtime_error naming the file that cannot be written.
RunScore WriteReport(const std::vector<SessionRecord>& records, const Scenario& scenario,
                     const ReportSettings& settings, const std::filesystem::path& out);

}  // namespace limpet
