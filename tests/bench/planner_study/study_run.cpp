// SPDX-License-Identifier: MIT
#include "tests/bench/planner_study/study_run.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <numbers>

#include "limpet/planning/home_path.hpp"
#include "limpet/planning/target_tour.hpp"
#include "limpet/planning/view_entropy.hpp"
#include "tests/bench/planner_study/study_scorer.hpp"
#include "tests/support/grid_heights.hpp"

namespace limpet {
namespace {

constexpr double kFrameSpacing = 0.125;  // 4 fps at 0.5 m/s
constexpr double kSeabedDown = 7.5;

Pose2 RandomStart(const Region& region, Meters radius, Random& random) {
  for (;;) {
    const Pose2 pose{random.Uniform(region.north_min(), region.north_max()),
                     random.Uniform(region.east_min(), region.east_max()),
                     random.Uniform(-std::numbers::pi, std::numbers::pi)};
    if (region.IsRecoverable(pose, radius)) {
      return pose;
    }
  }
}

LayerWeights Weights(double bottom) {
  const double sum = bottom + 3.0;
  return {bottom / sum, 1.0 / sum, 1.0 / sum, 1.0 / sum};
}

/// Lanes are a plan that is never edited.
MissionPlanParams PlanOf(const StudyCase& study) {
  MissionPlanParams params = study.plan;
  if (study.planner == "lanes") {
    params.first_edits = 0;
    params.lanes.with_bottom_first = false;
  }
  return params;
}

class Flight {
 public:
  Flight(const StudyCase& study, std::uint64_t seed)
      : study_(study),
        camera_(CameraOf(study)),
        region_(study.area),
        random_(seed, "study"),
        grid_(study.area),
        ground_(grid_,
                Footprint(
                    {.altitude = study.altitude, .object_height_max = study.area.object_height_max},
                    camera_),
                Weights(study.bottom_weight)),
        sight_(ground_),
        scorer_(study.area, study.altitude, camera_, random_),
        tree_random_(seed, "paper"),
        objective_(study.objective),
        plan_(PlanOf(study), Random(seed, "plan")) {
    pose_ = study.has_fixed_start ? Pose2{-12.5, -15.5, 0.5 * std::numbers::pi}
                                  : RandomStart(region_, study.beam.turn_radius, random_);
    if (study.is_change) {
      objective_.targets = FormerObjects(study.target_value);
    }
    home_ = pose_;
    Arrive(pose_, 0.0);
  }

  StudyResult Run() {
    while (path_ < study_.path_max_m && grid_.coverage().band_top < study_.band_top_stop) {
      ground_.Update(grid_);
      const std::clock_t begin = std::clock();  // of this process: the machine may be busy
      const std::optional<Option> chosen = Decide();
      const double took_ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      ++decisions_;
      total_ms_ += took_ms;
      result_.plan_ms_max = std::max(result_.plan_ms_max, took_ms);
      if (!chosen || chosen->path.length() < kFrameSpacing) {
        break;
      }
      Execute(chosen->path);
    }
    result_.seabed90 = scorer_.seabed().PathAt(0.90);
    result_.seabed95 = scorer_.seabed().PathAt(0.95);
    result_.band95 = scorer_.band().PathAt(0.95);
    result_.band99 = scorer_.band().PathAt(0.99);
    result_.top975 = top_.PathAt(0.975);
    if (grid_.coverage().band_top >= study_.band_top_stop) {
      result_.whole =
          path_ + HomePath(pose_, {home_.north, home_.east}, region_, study_.beam.turn_radius)
                      .path.length();
    }
    result_.frame = grid_.frame();
    result_.heights = HeightsOf(grid_);
    result_.plan_ms_mean = total_ms_ / std::max(1, decisions_);
    return result_;
  }

 private:
  std::optional<Option> Decide() {
    if (study_.planner == "paper") {
      return DecideLikeThePaper();
    }
    if (study_.planner == "plan" || study_.planner == "lanes") {
      return DecideByPlan();
    }
    if (ground_.SeenShare(0) > study_.late_share) {
      objective_.ground.frontier = study_.late_frontier;
    }
    std::vector<Option> options = BeamSearch(pose_, ground_, region_, objective_, study_.beam);
    if (UsefulShare(options) < study_.gap_below) {
      for (Option& option : GapPaths(pose_, ground_, region_, objective_, study_.gap)) {
        options.push_back(std::move(option));
      }
    }
    std::ranges::move(TargetTours(pose_, region_, objective_, study_.beam.turn_radius),
                      std::back_inserter(options));
    std::optional<Option> best;
    double best_rate = 0.0;
    for (const Option& option : options) {
      const double rate = ValueOf(option.path, objective_, ground_, sight_) / option.path.length();
      if (!best || rate > best_rate) {
        best = option;
        best_rate = rate;
      }
    }
    return best;
  }

  /// The plan of the whole mission, as it is.
  std::optional<Option> DecideByPlan() {
    TourGoal goal = study_.tour;
    goal.home_W = {home_.north, home_.east};
    goal.others = objective_;
    std::vector<Option> options;
    plan_.Offer({.pose = pose_,
                 .ground = &ground_,
                 .region = &region_,
                 .turn_radius = study_.beam.turn_radius,
                 .goal = goal,
                 .travelled = path_},
                "plan", options);
    if (options.empty()) return std::nullopt;
    plan_.OnChoice(options.front());
    return options.front();
  }

  /// The branch with the most entropy (eq. 17); its other views are kept for the next tree.
  std::optional<Option> DecideLikeThePaper() {
    std::vector<Option> branches =
        PaperTree(pose_, kept_, ground_, region_, study_.paper, tree_random_);
    kept_.clear();
    if (branches.empty()) {
      return std::nullopt;
    }
    const auto best = std::ranges::max_element(branches, {}, [this](const Option& branch) {
      return MapEntropyOf(branch.views, ground_, study_.paper_counts_band);
    });
    kept_.assign(best->views.begin() + 1, best->views.end());
    return *best;
  }

  /// Metres of useful track per metre of the first option, the beam's best.
  double UsefulShare(const std::vector<Option>& options) {
    return options.empty() ? 0.0
                           : sight_(options.front().path).new_area / ground_.swath() /
                                 options.front().path.length();
  }

  void Execute(const DubinsPath& path) {
    const double flown =
        study_.planner == "paper" ? path.length() : std::min(study_.execute_m, path.length());
    const double from = path_;
    const int frames = std::max(1, static_cast<int>(flown / kFrameSpacing));
    for (int i = 1; i <= frames; ++i) {
      Arrive(path.At(i * flown / frames), from + i * flown / frames);
    }
  }

  void Arrive(const Pose2& pose, double path) {
    pose_ = pose;
    path_ = path;
    result_.track.push_back(pose);
    scorer_.Frame(pose, path);
    Pose X_WB;
    X_WB.p_WB = {pose.north, pose.east, kSeabedDown - study_.altitude};
    X_WB.yaw = pose.yaw;
    grid_.Observe(X_WB, study_.altitude, camera_);
    top_.Note(path, grid_.coverage().band_top);
    std::erase_if(objective_.targets,
                  [&pose](const Target& target) { return target.IsSeenFrom(pose); });
    if (study_.is_change && objective_.targets.empty() && !result_.targets_seen) {
      result_.targets_seen = path;
    }
  }

  const StudyCase& study_;
  CameraModel camera_;
  Region region_;
  Random random_;
  SurveyGrid grid_;
  Ground ground_;
  SeenAlong sight_;
  StudyScorer scorer_;
  Random tree_random_;
  std::vector<Pose2> kept_;
  Objective objective_;
  Pose2 pose_, home_;
  MissionPlan plan_;
  double path_ = 0.0, total_ms_ = 0.0;
  int decisions_ = 0;
  LevelLog top_;
  StudyResult result_;
};

}  // namespace

CameraModel CameraOf(const StudyCase& study) {
  return study.camera == "60x45" ? CameraModel::FromFieldOfView(640, 480,
                                                                {.across = RadiansFromDegrees(60.0),
                                                                 .along = RadiansFromDegrees(45.0)})
                                 : CameraModel();
}

std::vector<Target> FormerObjects(double value) {
  std::vector<Target> targets;
  for (const auto& [north, east] :
       {std::pair{4.0, 1.0}, std::pair{2.0, 10.0}, std::pair{6.0, -3.0}, std::pair{-6.0, -5.0}}) {
    targets.push_back({.north = north, .east = east, .window = {1.5, 1.5}, .value = value});
  }
  return targets;
}

StudyResult RunStudy(const StudyCase& study, std::uint64_t seed) {
  return Flight(study, seed).Run();
}

}  // namespace limpet
