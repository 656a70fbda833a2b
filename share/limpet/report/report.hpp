// SPDX-License-Identifier: MIT
// What a run leaves for people and programs: report.json, figures/*.svg, report.html.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "limpet/mission/scenario.hpp"
#include "limpet/scoring/report_settings.hpp"
#include "limpet/scoring/scorer.hpp"
#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// Text of files by their names in the run's folder.
using ReportFiles = std::map<std::string, std::string>;

/// `run.json`, from which `limpet report` can make a report again. Write it before the run, so that
/// an interrupted run can be reported too.
[[nodiscard]] ReportFiles RunDescriptionFiles(const ReportSettings& settings,
                                              const Scenario& scenario);

/// A run as judged, and the files that say so.
struct ComposedReport {
  RunScore score;
  ReportFiles files;  ///< run.json, report.json, figures/*.svg and report.html
};
/// Scores the sessions and composes their report; writes nothing.
[[nodiscard]] ComposedReport ComposeReport(const std::vector<SessionRecord>& records,
                                           const Scenario& scenario,
                                           const ReportSettings& settings);

}  // namespace limpet
