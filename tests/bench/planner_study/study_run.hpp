// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limpet/planning/beam_search.hpp"
#include "limpet/planning/gap_paths.hpp"
#include "limpet/planning/mission_plan.hpp"
#include "limpet/planning/paper_tree.hpp"

namespace limpet {

/// One planner on one area, with perfect knowledge of the pose.
struct StudyCase {
  std::string planner = "beam";  ///< beam, plan, lanes or paper
  std::string camera = "80x60";  ///< or 60x45
  SurveyArea area{-15.0, 15.0, -18.0, 18.0, 2.0, 2.0};
  double altitude = 4.0;
  double execute_m = 8.0;  ///< flown before the next decision
  double path_max_m = 700.0;
  double band_top_stop = 0.99;   ///< of the planner's own grid
  bool has_fixed_start = false;  ///< (-12.5, -15.5) heading east; else random
  bool is_change = false;        ///< former objects of Table 1 are targets
  double target_value = 60.0;
  /// Its frontier was best of beam search alone.
  Objective objective{.ground = {.cover = 1.0, .frontier = 0.325}, .targets = {}, .terms = {}};
  /// Gap paths are offered when the beam's best shows less than this [m of useful track per m].
  double gap_below = 0.02;
  double late_share = 2.0;  ///< seabed share from which late_frontier holds
  double late_frontier = 1.0;
  double bottom_weight = 2.0;  ///< of the lowest layer against each other one
  BeamParams beam;
  GapParams gap;
  PaperTreeParams paper;
  TourGoal tour;
  MissionPlanParams plan;
  bool paper_counts_band = false;  ///< entropy of the band, not of the bottom alone
};

struct StudyResult {
  std::optional<double> seabed90, seabed95, band95, band99, top975, targets_seen, whole;
  double plan_ms_mean = 0.0, plan_ms_max = 0.0;
  std::vector<Pose2> track;
  GridFrame frame;
  std::vector<float> heights;  ///< of the planner's grid at the end
};

[[nodiscard]] StudyResult RunStudy(const StudyCase& study, std::uint64_t seed);
[[nodiscard]] CameraModel CameraOf(const StudyCase& study);
/// Former objects of Table 1 (north, east).
[[nodiscard]] std::vector<Target> FormerObjects(double value);

}  // namespace limpet
