// SPDX-License-Identifier: MIT
#include "limpet/figures/figures.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/topics/survey_phase.hpp"

namespace limpet {

std::string RunName(const FigureSource& source) {
  return fmt::format("{}, {} session, seed {}", source.settings.mission, source.record.name,
                     source.settings.seed);
}

SurveyArea AreaOf(const SessionRecord& record) {
  if (record.area) return *record.area;
  return WidenedTo(record.truth.empty() ? record.nav : record.truth, {});
}

SurveyArea WidenedTo(const PoseTrack& track, SurveyArea area) {
  for (std::size_t i = 0; i < track.size(); ++i) {
    area.north_min = std::min(area.north_min, track.north(i));
    area.north_max = std::max(area.north_max, track.north(i));
    area.east_min = std::min(area.east_min, track.east(i));
    area.east_max = std::max(area.east_max, track.east(i));
  }
  return area;
}

const PoseTrack& WayOf(const FigureSource& source) {
  return source.score.has_truth ? source.record.truth : source.record.nav;
}

double SurveyStartOf(const FigureSource& source) {
  const PoseTrack& way = WayOf(source);
  const double first = way.empty() ? 0.0 : way.time(0);
  return source.record.PhaseStart(SurveyPhase::kSurvey).value_or(Seconds(first)).value();
}

std::vector<Figure> FiguresOf(const FigureSource& source) {
  const bool has_grid = source.record.grid.frame.rows > 0;
  const bool has_survey = !source.score.coverage.curve.path_m.empty();
  const bool has_way = WayOf(source).size() > 1;
  std::vector<Figure> figures;
  if (has_way) figures.push_back(TrackFigure(source));
  if (!source.score.former.empty()) figures.push_back(ChangeFigure(source));
  figures.push_back(ObjectsFigure(source));
  if (!source.score.opis.found.empty()) figures.push_back(CloseUpFigure(source));
  if (has_way && !source.record.beliefs.empty()) figures.push_back(BeliefFigure(source));
  if (has_survey) figures.push_back(CoverageFigure(source));
  if (has_grid) figures.push_back(DepthFigure(source));
  if (source.score.nav.curve.time_s.size() > 1) figures.push_back(NavigationFigure(source));
  return figures;
}

}  // namespace limpet
