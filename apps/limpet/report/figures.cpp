// SPDX-License-Identifier: MIT
#include "apps/limpet/report/figures.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace limpet {

std::string RunName(const FigureSource& source) {
  return fmt::format("{}, {} session, seed {}", source.settings.mission, source.record.name,
                     source.settings.seed);
}

SurveyArea AreaOf(const SessionRecord& record) {
  if (record.area) return *record.area;
  SurveyArea area;
  for (std::size_t i = 0; i < record.truth.size(); ++i) {
    area.north_min = std::min(area.north_min, record.truth.north(i));
    area.north_max = std::max(area.north_max, record.truth.north(i));
    area.east_min = std::min(area.east_min, record.truth.east(i));
    area.east_max = std::max(area.east_max, record.truth.east(i));
  }
  return area;
}

std::vector<Figure> FiguresOf(const FigureSource& source) {
  const bool has_grid = source.record.grid.frame.rows > 0;
  const bool has_survey = !source.score.coverage.curve.path_m.empty();
  std::vector<Figure> figures;
  if (source.record.truth.size() > 1) figures.push_back(TrackFigure(source));
  if (source.record.name == "change") figures.push_back(ChangeFigure(source));
  figures.push_back(ObjectsFigure(source));
  if (!source.score.opis.found.empty()) figures.push_back(CloseUpFigure(source));
  if (has_survey && !source.record.beliefs.empty()) figures.push_back(BeliefFigure(source));
  if (has_survey) figures.push_back(CoverageFigure(source));
  if (has_grid) figures.push_back(DepthFigure(source));
  if (source.score.nav.curve.time_s.size() > 1) figures.push_back(NavigationFigure(source));
  return figures;
}

}  // namespace limpet
