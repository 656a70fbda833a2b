// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/scoring/scorer.hpp"
#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// A figure of the report.
struct Figure {
  std::string file;     ///< its name in figures/, e.g. discovery_track.svg
  std::string caption;  ///< what one sees and how to read it
  std::string svg;
};

/// All that a figure is drawn from.
struct FigureSource {
  const SessionRecord& record;
  const SessionScore& score;
  const ReportSettings& settings;
  const Scenario& scenario;
};

/// Track and decisions over the ground that was seen.
[[nodiscard]] Figure TrackFigure(const FigureSource& source);
/// The seabed's depth as the vehicle mapped it.
[[nodiscard]] Figure DepthFigure(const FigureSource& source);
/// Objects as smoother and map know them, beside where they truly are.
[[nodiscard]] Figure ObjectsFigure(const FigureSource& source);
/// Each object that was found, enlarged.
[[nodiscard]] Figure CloseUpFigure(const FigureSource& source);
/// What became of each object since the former session.
[[nodiscard]] Figure ChangeFigure(const FigureSource& source);
/// Error of the estimate with its own 3-sigma bounds, and of dead reckoning.
[[nodiscard]] Figure NavigationFigure(const FigureSource& source);
/// Share of bottom and band seen against the way travelled, and against time.
[[nodiscard]] Figure CoverageFigure(const FigureSource& source);
/// How sure the vehicle was about each object over the way travelled.
[[nodiscard]] Figure BeliefFigure(const FigureSource& source);

/// Every figure that the session has data for, in the order of the report.
[[nodiscard]] std::vector<Figure> FiguresOf(const FigureSource& source);

/// "table1, discovery session, seed 1"; begins every figure's subtitle.
[[nodiscard]] std::string RunName(const FigureSource& source);
/// The area drawn: the survey's, or around the track when it was never told.
[[nodiscard]] SurveyArea AreaOf(const SessionRecord& record);
/// The area with its box widened to hold all of a track.
[[nodiscard]] SurveyArea WidenedTo(const PoseTrack& track, SurveyArea area);
/// The way that figures draw and measure along: the true one, or else the estimated.
[[nodiscard]] const PoseTrack& WayOf(const FigureSource& source);
/// MOOS time at which the survey, or else that way, begins [s].
[[nodiscard]] double SurveyStartOf(const FigureSource& source);

}  // namespace limpet
