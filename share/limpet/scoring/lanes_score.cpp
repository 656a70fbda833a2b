// SPDX-License-Identifier: MIT
#include "limpet/scoring/lanes_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "limpet/core/frames.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/planning/lane_tours.hpp"
#include "limpet/planning/tour_path.hpp"

namespace limpet {
namespace {

/// Tours are compared by what planners count as seen, so many of the best by what truly is.
constexpr std::size_t kScored = 6;
/// Planners count less at the band's top than scorers do: lanes just wide enough lack this much.
constexpr double kPlannedShare = 0.93;

/// A survey along lanes: where it starts, how fast it is, where it goes home.
struct LaneSurvey {
  const SurveyArea& area;
  Pose2 start;
  PlanePoint home;
  double speed;
};

std::vector<FlownTour> BestLanes(const LaneSurvey& survey, const ReportSettings& settings) {
  const Ground ground(
      SurveyGrid(survey.area),
      Footprint(settings.altitude_m, survey.area.object_height_max, settings.camera_geometry));
  const Region region(survey.area);
  const Meters radius(settings.turning_radius_m);
  TourJudge judge(ground, region, radius);
  judge.Reset(DubinsPath(survey.start), {.finish_share = kPlannedShare,
                                         .early_weight = 0.0,
                                         .most_weight = 0.0,
                                         .home = survey.home});
  std::vector<SurveyTour> tours = LaneTours(judge, {.with_bottom_first = false});
  tours.resize(std::min(tours.size(), kScored));
  std::vector<FlownTour> flown;
  for (const SurveyTour& tour : tours) {
    flown.push_back(Fly(DubinsPath(survey.start), tour, region, radius));
    if (flown.back().passes.empty()) flown.pop_back();
  }
  return flown;
}

/// A level camera's frames along the path, as many to the metre as the survey's camera had.
SurveyFrames FramesAlong(const DubinsPath& path, double speed, const Scenario& scenario,
                         const ReportSettings& settings) {
  SurveyFrames frames;
  const Seabed seabed(scenario.seabed);
  path.Sample(speed / settings.frame_rate_hz, [&](const Pose2& pose, double way) {
    const double down = seabed.Depth(pose.north, pose.east) - settings.altitude_m;
    frames.path_m.push_back(way);
    frames.time_s.push_back(way / speed);
    frames.X_WB.push_back({{pose.north, pose.east, down}, 0.0, 0.0, pose.yaw});
  });
  return frames;
}

/// Least way there and home over all places to stop at where enough has been seen; from the path's
/// end if that never is.
double WayHome(const SurveyFrames& frames, const CoverageScore& coverage, const PlanePoint& home) {
  double least = std::numeric_limits<double>::infinity();
  const std::size_t last = frames.X_WB.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    if (coverage.curve.band[i] < kLaneShare && i < last) continue;
    const double back = (frames.X_WB[i].p_WB.head<2>() - home).norm();
    least = std::min(least, frames.path_m[i] + back);
  }
  return least;
}

struct ScoredLanes {
  LanesScore score;
  double seen = 0.0;  ///< of the band, as far as it counts
};

ScoredLanes ScoreOf(const FlownTour& lanes, const LaneSurvey& survey, const Scenario& scenario,
                    const ReportSettings& settings) {
  const SurveyFrames frames = FramesAlong(lanes.path, survey.speed, scenario, settings);
  const CoverageScore coverage = ScoreCoverage(frames, survey.area, scenario, settings, {});
  const double way = WayHome(frames, coverage, survey.home);
  return {.score = {.passes = static_cast<int>(lanes.passes.size()),
                    .direction_deg = MoosHeadingFromYaw(lanes.passes.front().in.yaw),
                    .path_m = way,
                    .time_s = way / survey.speed,
                    .seabed = coverage.seabed,
                    .band = coverage.band},
          .seen = std::min(coverage.detected_band, kLaneShare)};
}

bool IsBetter(const ScoredLanes& a, const ScoredLanes& b) {
  return a.seen != b.seen ? a.seen > b.seen : a.score.path_m < b.score.path_m;
}

}  // namespace

std::optional<LanesScore> ScoreLanes(const SurveyArea& area, const Pose2& start,
                                     const HomePoint& home, double speed, const Scenario& scenario,
                                     const ReportSettings& settings) {
  const double box_m2 = (area.north_max - area.north_min) * (area.east_max - area.east_min);
  const bool is_reckoned = !ProblemOf(area) && speed > 0.0 &&
                           box_m2 <= kMostLaneCells * SurveyGrid::kCell_m * SurveyGrid::kCell_m;
  if (!is_reckoned) return std::nullopt;
  const LaneSurvey survey{
      .area = area, .start = start, .home = {home.north, home.east}, .speed = speed};
  std::optional<ScoredLanes> best;
  for (const FlownTour& tour : BestLanes(survey, settings)) {
    ScoredLanes lanes = ScoreOf(tour, survey, scenario, settings);
    if (!best || IsBetter(lanes, *best)) best = std::move(lanes);
  }
  return best ? std::optional<LanesScore>(best->score) : std::nullopt;
}

}  // namespace limpet
