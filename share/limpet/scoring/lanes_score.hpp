// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/planning/pose2.hpp"
#include "limpet/scoring/coverage_score.hpp"

namespace limpet {

/// What conventional lanes over the same area would take: parallel and evenly spaced, in the
/// direction, the number and the order that bring the vehicle home soonest with `kLaneShare` of the
/// band seen (or, where none sees that much, that see most), with the same turns inside the same
/// region. Reckoned, not flown: no doubt of the vehicle's place, no look at an object, no fix on
/// the way; of a few tours of lanes the best, so others may be shorter.
struct LanesScore {
  int passes = 0;                           ///< straight pieces
  double direction_deg = 0.0;               ///< of the first of them, clockwise from north
  double path_m = 0.0;                      ///< start of the survey to home, inside the region
  double time_s = 0.0;                      ///< for that, as fast as the survey was on average
  std::vector<CoverageLevel> seabed, band;  ///< as CoverageScore's, of that way and no more
};
inline constexpr double kLaneShare = 0.975;

/// The survey that lanes are reckoned beside.
struct SurveyBesideLanes {
  Pose2 start;  ///< of the survey, the dive behind it
  HomePoint home;
  double speed = 0.0;           ///< over ground, on average [m/s]
  std::vector<Pose> dive_X_WB;  ///< frames of the dive: what they show need no lanes show again
};

/// From its start and back to its home, as fast as it. Nothing if no lane can be flown, or if the
/// area is none or too large to be reckoned with in seconds (`kMostLaneCells` cells).
[[nodiscard]] std::optional<LanesScore> ScoreLanes(const SurveyArea& area,
                                                   const SurveyBesideLanes& beside,
                                                   const Scenario& scenario,
                                                   const ReportSettings& settings);
inline constexpr double kMostLaneCells = 4e5;

}  // namespace limpet
