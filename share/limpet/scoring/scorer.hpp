// SPDX-License-Identifier: MIT
// The only place on the vehicle's side of the code where the truth enters.
#pragma once

#include <string>
#include <vector>

#include "limpet/scoring/coverage_score.hpp"
#include "limpet/scoring/energy_record.hpp"
#include "limpet/scoring/fence_score.hpp"
#include "limpet/scoring/lanes_score.hpp"
#include "limpet/scoring/lower_bound.hpp"
#include "limpet/scoring/nav_score.hpp"
#include "limpet/scoring/obstacle_score.hpp"
#include "limpet/scoring/opi_score.hpp"
#include "limpet/scoring/option_wins.hpp"
#include "limpet/scoring/phase_times.hpp"
#include "limpet/scoring/pictured_object.hpp"
#include "limpet/scoring/report_settings.hpp"
#include "limpet/scoring/warning_record.hpp"

namespace limpet {

/// What the vehicle itself says that it could see.
struct WaterScore {
  WaterVisibility visibility;
  Coverage believed;         ///< at the end
  double seen_from_m = 0.0;  ///< height above the seabed from which on things were in sight
};

/// Every number of one session in report.json.
struct SessionScore {
  std::string name;
  std::string former;  ///< session it is compared with; empty: none
  /// Without true poses and a scenario nothing is judged: coverage, nav and home_error_m say
  /// nothing, and of `opis` only what was reported and decided does.
  bool has_truth = true;
  CoverageScore coverage;
  std::optional<LowerBound> bound;       ///< nothing if no area was told
  std::optional<LanesScore> lanes;       ///< nothing without truth, area or survey
  std::vector<OptionWins> wins;          ///< whose options were flown
  std::optional<WaterScore> water;       ///< nothing if nobody said
  std::optional<WaterCurrent> current;   ///< by the vehicle's own account
  std::optional<EnergyRecord> energy;    ///< nothing of a vehicle without a battery
  std::vector<ObstacleScore> obstacles;  ///< none without truth
  std::optional<FenceScore> fences;      ///< nothing without truth or area
  NavScore nav;
  OpiScores opis;
  std::vector<PicturedObject> pictured;  ///< none without images
  double path_m = 0.0;                   ///< way of the whole session: true, or else as estimated
  double duration_s = 0.0;               ///< first to last true, or else estimated, pose
  std::vector<PhaseTime> phases;         ///< where that time went
  double survey_start_s = 0.0;           ///< after the session's start
  std::optional<double> survey_path_m;   ///< way from there to the ascent; nothing without truth
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

/// The session that `record` is compared with: the one that the vehicle says, else the one before
/// it in the run's order; empty if it is the first.
[[nodiscard]] std::string FormerOf(const SessionRecord& record, const ReportSettings& settings);

/// Scores one session against the truth, if there is one. A session without survey scores zero
/// coverage.
[[nodiscard]] SessionScore ScoreSession(const SessionRecord& record, const Scenario& scenario,
                                        const ReportSettings& settings);
/// Scores every session; where the settings do not give their order, that of `records` counts.
[[nodiscard]] RunScore ScoreRun(const std::vector<SessionRecord>& records, const Scenario& scenario,
                                const ReportSettings& settings);

}  // namespace limpet
