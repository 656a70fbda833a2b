// SPDX-License-Identifier: MIT
// The only place on the vehicle's side of the code where the truth enters.
#pragma once

#include <string>
#include <vector>

#include "apps/limpet/report/coverage_score.hpp"
#include "apps/limpet/report/nav_score.hpp"
#include "apps/limpet/report/opi_score.hpp"
#include "apps/limpet/report/report_settings.hpp"
#include "apps/limpet/report/warning_record.hpp"

namespace limpet {

/// Every number of one session in report.json.
struct SessionScore {
  std::string name;
  CoverageScore coverage;
  NavScore nav;
  OpiScores opis;
  double path_m = 0.0;          ///< true way of the whole session
  double duration_s = 0.0;      ///< first to last true pose
  double survey_start_s = 0.0;  ///< after the session's start
  std::optional<double> wall_s;
  std::vector<WarningRecord> warnings;
  std::optional<Seconds> begun;  ///< MOOS time of the first message
  std::string ended;             ///< home, aborted, timeout or lost
  /// Horizontal distance of the true end from the start point; nothing without a true pose.
  std::optional<double> home_error_m;
  [[nodiscard]] std::optional<double> realtime_factor() const {
    if (!wall_s || *wall_s <= 0.0) return std::nullopt;
    return duration_s / *wall_s;
  }
};

/// A whole run as judged.
struct RunScore {
  ReportSettings settings;
  std::vector<SessionScore> sessions;
};

/// Scores one session against the truth. A session without truth or survey scores zero coverage.
[[nodiscard]] SessionScore ScoreSession(const SessionRecord& record, const Scenario& scenario,
                                        const ReportSettings& settings);
[[nodiscard]] RunScore ScoreRun(const std::vector<SessionRecord>& records, const Scenario& scenario,
                                const ReportSettings& settings);

}  // namespace limpet
