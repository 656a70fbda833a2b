// SPDX-License-Identifier: MIT
#include "apps/limpet/report/scorer.hpp"

#include <cmath>

namespace limpet {
namespace {

std::vector<Eigen::Vector3d> FormerPlaces(const SessionRecord& record, const Scenario& scenario) {
  std::vector<Eigen::Vector3d> places;
  if (record.name != "change") return places;
  for (const ScenarioOpi& opi : scenario.opis) {
    if (const auto place = opi.Place("discovery")) places.push_back(*place);
  }
  return places;
}

}  // namespace

SessionScore ScoreSession(const SessionRecord& record, const Scenario& scenario,
                          const ReportSettings& settings) {
  SessionScore score;
  score.name = record.name;
  score.ended = record.ended.empty() ? "aborted" : record.ended;
  score.warnings = record.warnings;
  score.begun = record.begun;
  if (const auto wall = settings.wall_s.find(record.name); wall != settings.wall_s.end()) {
    score.wall_s = wall->second;
  }
  const SurveyFrames frames = FramesOfSurvey(record, settings);
  score.coverage = ScoreCoverage(frames, record.area.value_or(SurveyArea{}), scenario, settings,
                                 FormerPlaces(record, scenario));
  if (!record.truth.empty()) {
    const std::size_t last = record.truth.size() - 1;
    score.path_m = record.truth.path(last);
    score.duration_s = record.truth.time(last) - record.truth.time(0);
    score.home_error_m = std::hypot(record.truth.north(last) - scenario.start.north_m,
                                    record.truth.east(last) - scenario.start.east_m);
    const double start =
        record.PhaseStart("SURVEY").value_or(Seconds(record.truth.time(0))).value();
    score.survey_start_s = start - record.truth.time(0);
    score.nav = ScoreNavigation(record, start);
  }
  score.opis = ScoreOpis(record, scenario, score.nav.offset);
  return score;
}

RunScore ScoreRun(const std::vector<SessionRecord>& records, const Scenario& scenario,
                  const ReportSettings& settings) {
  RunScore run{settings, {}};
  for (const SessionRecord& record : records) {
    run.sessions.push_back(ScoreSession(record, scenario, settings));
  }
  return run;
}

}  // namespace limpet
