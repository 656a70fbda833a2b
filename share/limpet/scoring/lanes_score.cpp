// SPDX-License-Identifier: MIT
#include "limpet/scoring/lanes_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "limpet/core/frames.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/planning/home_path.hpp"
#include "limpet/planning/lane_tours.hpp"
#include "limpet/planning/tour_path.hpp"
#include "limpet/planning/transit_path.hpp"

namespace limpet {
namespace {

/// Tours are compared by what planners count as seen, so many of the best by what truly is.
constexpr std::size_t kScored = 6;
/// Planners count less at the band's top than scorers do: lanes just wide enough lack this much.
constexpr double kPlannedShare = 0.93;

/// A survey along lanes, from where and as fast as the one that they are reckoned beside.
struct LaneSurvey {
  const SurveyArea& area;
  const Region& region;
  Meters turn_radius;
  PlanePoint home;
  const SurveyBesideLanes& beside;
};

/// What leads into the region, for a survey that begins outside it.
DubinsPath WayIn(const LaneSurvey& survey) {
  const Pose2& start = survey.beside.start;
  if (survey.region.Outside(start) <= 0.0) return DubinsPath(start);
  const PlanePoint begin(start.north, start.east);
  const auto transit = TransitPath(start, begin, survey.region, survey.turn_radius);
  return transit ? transit->path : DubinsPath(start);
}

std::vector<FlownTour> BestLanes(const LaneSurvey& survey, const ReportSettings& settings) {
  const Ground ground(SurveyGrid(survey.area),
                      Footprint({.altitude = settings.altitude_m,
                                 .object_height_max = survey.area.object_height_max},
                                settings.camera_geometry));
  const DubinsPath way_in = WayIn(survey);
  TourJudge judge(ground, survey.region, survey.turn_radius);
  judge.Reset(way_in, {.finish_share = kPlannedShare,
                       .early_weight = 0.0,
                       .most_weight = 0.0,
                       .home_W = survey.home});
  std::vector<SurveyTour> tours = LaneTours(judge, {.with_bottom_first = false});
  tours.resize(std::min(tours.size(), kScored));
  std::vector<FlownTour> flown;
  for (const SurveyTour& tour : tours) {
    flown.push_back(Fly(way_in, tour, survey.region, survey.turn_radius));
    if (flown.back().passes.empty()) flown.pop_back();
  }
  return flown;
}

/// A level camera's frames along the path, as many to the metre as the survey's camera had, behind
/// those of the dive that it had.
SurveyFrames FramesAlong(const DubinsPath& path, const SurveyBesideLanes& beside,
                         const Scenario& scenario, const ReportSettings& settings) {
  SurveyFrames frames;
  frames.dive_X_WB = beside.dive_X_WB;
  const Seabed seabed(scenario.seabed);
  path.Sample(beside.speed / settings.frame_rate_hz, [&](const Pose2& pose, double way) {
    const double down = seabed.Depth({pose.north, pose.east}) - settings.altitude_m;
    frames.path_m.push_back(way);
    frames.time_s.push_back(way / beside.speed);
    frames.X_WB.push_back({{pose.north, pose.east, down}, 0.0, 0.0, pose.yaw});
  });
  return frames;
}

/// The path to the place to stop at from which home is reached soonest, of all where enough has
/// been seen, and home; from the path's end if that never is. Which place that is goes by the
/// straight way home.
DubinsPath ThereAndHome(const DubinsPath& path, const SurveyFrames& frames,
                        const CoverageScore& coverage, const LaneSurvey& survey) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t stop = frames.X_WB.size() - 1;
  for (std::size_t i = frames.X_WB.size(); i-- > 0;) {
    if (coverage.curve.band[i] < kLaneShare && i + 1 < frames.X_WB.size()) break;
    const double back = (frames.X_WB[i].p_WB.head<2>() - survey.home).norm();
    if (frames.path_m[i] + back < least) least = frames.path_m[i] + back, stop = i;
  }
  const double there = frames.path_m[stop];
  DubinsPath whole = path.Prefix(there);
  whole.Append(HomePath(whole.end(), survey.home, survey.region, survey.turn_radius).path);
  return whole;
}

struct ScoredLanes {
  LanesScore score;
  DubinsPath path;    ///< to where they are left, and home
  double seen = 0.0;  ///< of the band on all lanes, as far as it counts
};

ScoredLanes ScoreOf(const FlownTour& lanes, const LaneSurvey& survey, const Scenario& scenario,
                    const ReportSettings& settings) {
  const SurveyFrames frames = FramesAlong(lanes.path, survey.beside, scenario, settings);
  const CoverageScore coverage = ScoreCoverage(frames, survey.area, scenario, settings, {});
  DubinsPath path = ThereAndHome(lanes.path, frames, coverage, survey);
  const double way = path.length();
  return {.score = {.passes = static_cast<int>(lanes.passes.size()),
                    .direction_deg = MoosHeadingFromYaw(lanes.passes.front().in.yaw),
                    .path_m = way,
                    .time_s = way / survey.beside.speed,
                    .seabed = {},
                    .band = {}},
          .path = std::move(path),
          .seen = std::min(coverage.detected_band, kLaneShare)};
}

/// Shares are of the way that is said, home included: of a tour that were flown on they would
/// belong to no figure of it.
LanesScore WithLevels(const ScoredLanes& lanes, const LaneSurvey& survey, const Scenario& scenario,
                      const ReportSettings& settings) {
  const SurveyFrames frames = FramesAlong(lanes.path, survey.beside, scenario, settings);
  CoverageScore coverage = ScoreCoverage(frames, survey.area, scenario, settings, {});
  LanesScore score = lanes.score;
  score.seabed = std::move(coverage.seabed);
  score.band = std::move(coverage.band);
  return score;
}

bool IsBetter(const ScoredLanes& a, const ScoredLanes& b) {
  return a.seen != b.seen ? a.seen > b.seen : a.score.path_m < b.score.path_m;
}

}  // namespace

std::optional<LanesScore> ScoreLanes(const SurveyArea& area, const SurveyBesideLanes& beside,
                                     const Scenario& scenario, const ReportSettings& settings) {
  const double box_m2 = (area.north_max - area.north_min) * (area.east_max - area.east_min);
  const bool is_reckoned = !ProblemOf(area) && beside.speed > 0.0 &&
                           box_m2 <= kMostLaneCells * kGridCell_m * kGridCell_m;
  if (!is_reckoned) return std::nullopt;
  const Region region(area);
  const LaneSurvey survey{.area = area,
                          .region = region,
                          .turn_radius = Meters(settings.turning_radius_m),
                          .home = {beside.home.north, beside.home.east},
                          .beside = beside};
  std::optional<ScoredLanes> best;
  for (const FlownTour& tour : BestLanes(survey, settings)) {
    ScoredLanes lanes = ScoreOf(tour, survey, scenario, settings);
    if (!best || IsBetter(lanes, *best)) best = std::move(lanes);
  }
  return best ? std::optional(WithLevels(*best, survey, scenario, settings)) : std::nullopt;
}

}  // namespace limpet
