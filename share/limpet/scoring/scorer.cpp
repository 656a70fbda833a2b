// SPDX-License-Identifier: MIT
#include "limpet/scoring/scorer.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

std::vector<Eigen::Vector3d> FormerPlaces(const std::string& former, const Scenario& scenario) {
  std::vector<Eigen::Vector3d> places;
  for (const ScenarioOpi& opi : scenario.opis) {
    if (const auto place = opi.Place(former)) places.push_back(*place);
  }
  return places;
}

void ScoreWay(const SessionRecord& record, const PoseTrack& track, SessionScore& score) {
  if (track.empty()) return;
  const std::size_t last = track.size() - 1;
  score.path_m = track.path(last);
  score.duration_s = track.time(last) - track.time(0);
  score.phases = TimesOfPhases(record, Seconds(track.time(last)));
  score.wins = OptionWinsOf(record, track);
}

/// The lanes that this survey is to beat: from where it began, at its own mean speed.
std::optional<LanesScore> LanesBeside(const SessionRecord& record, const SurveyFrames& frames,
                                      const Scenario& scenario, const ReportSettings& settings) {
  if (!record.area || frames.X_WB.empty() || frames.time_s.back() <= 0.0) return std::nullopt;
  const Pose& X_WB = frames.X_WB.front();
  const Pose2 start{.north = X_WB.p_WB.x(), .east = X_WB.p_WB.y(), .yaw = X_WB.yaw};
  const HomePoint home = record.home.value_or(
      HomePoint{.north = scenario.start.north_m, .east = scenario.start.east_m});
  return ScoreLanes(*record.area,
                    {.start = start,
                     .home = home,
                     .speed = frames.path_m.back() / frames.time_s.back(),
                     .dive_X_WB = frames.dive_X_WB},
                    scenario, settings);
}

void ScoreAgainstTruth(const SessionRecord& record, const Scenario& scenario,
                       const ReportSettings& settings, SessionScore& score) {
  const SurveyFrames frames = FramesOfSurvey(record, settings);
  score.coverage = ScoreCoverage(frames, record.area.value_or(SurveyArea{}), scenario, settings,
                                 FormerPlaces(score.former, scenario));
  score.lanes = LanesBeside(record, frames, scenario, settings);
  if (!frames.path_m.empty()) score.survey_path_m = frames.path_m.back();
  const std::size_t last = record.truth.size() - 1;
  score.home_error_m = std::hypot(record.truth.north(last) - scenario.start.north_m,
                                  record.truth.east(last) - scenario.start.east_m);
  const double start =
      record.PhaseStart(SurveyPhase::kSurvey).value_or(Seconds(record.truth.time(0))).value();
  score.survey_start_s = start - record.truth.time(0);
  score.obstacles = ScoreObstacles(record.truth, scenario);
  score.fences = ScoreFences(record);
  score.nav = ScoreNavigation(record, start);
  score.opis = ScoreOpis(record, score.former, scenario, score.nav.offset);
}

}  // namespace

std::string FormerOf(const SessionRecord& record, const ReportSettings& settings) {
  if (!record.former.empty()) return record.former;
  const auto& order = settings.sessions;
  const auto own = std::find(order.begin(), order.end(), record.name);
  return own == order.end() || own == order.begin() ? "" : *std::prev(own);
}

SessionScore ScoreSession(const SessionRecord& record, const Scenario& scenario,
                          const ReportSettings& settings) {
  SessionScore score;
  score.name = record.name;
  score.former = FormerOf(record, settings);
  score.has_truth = settings.has_scenario && !record.truth.empty();
  score.ended = record.ended.empty() ? "aborted" : record.ended;
  score.warnings = record.warnings;
  score.energy = record.energy;
  score.current = record.current;
  if (record.water && !record.believed_coverage.empty()) {
    score.water = WaterScore{.visibility = *record.water,
                             .believed = record.believed_coverage.back().value,
                             .seen_from_m = record.grid.SeenFloor()};
  }
  if (record.area) score.bound = LowerBoundOf(*record.area, settings);
  score.begun = record.begun;
  if (const auto wall = settings.wall_s.find(record.name); wall != settings.wall_s.end()) {
    score.wall_s = wall->second;
  }
  ScoreWay(record, score.has_truth ? record.truth : record.nav, score);
  if (score.has_truth) {
    ScoreAgainstTruth(record, scenario, settings, score);
  } else {
    score.opis = ReportedOpis(record, !score.former.empty());
  }
  score.pictured = PicturedObjects(record, score.opis);
  return score;
}

RunScore ScoreRun(const std::vector<SessionRecord>& records, const Scenario& scenario,
                  const ReportSettings& settings) {
  RunScore run{settings, {}};
  ReportSettings in_order = settings;
  if (in_order.sessions.empty()) {
    for (const SessionRecord& record : records)
      in_order.sessions.push_back(record.name);
  }
  for (const SessionRecord& record : records) {
    run.sessions.push_back(ScoreSession(record, scenario, in_order));
  }
  return run;
}

}  // namespace limpet
