// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/preflight/mission_reading.hpp"
#include "limpet/survey/mission_area.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// What a survey is made of, from the blocks of pSurvey and pHelm and the behaviors. Metres, m/s.
struct SurveyFacts {
  SurveyArea area;                       ///< of its box alone if there is a problem
  std::optional<AreaProblem> problem{};  ///< why there is no area
  double wanted_m2 = 0.0;                ///< ground that is to be seen
  Setting north_min, north_max, east_min, east_max;
  Setting outline;  ///< or the file that holds it; the default for a rectangle
  Setting altitude, band;
  CameraModel camera;
  Setting speed;  ///< of the first BHV_FollowPath; 0 if there is none
  double turning_radius = 0.0;

  [[nodiscard]] double north_extent() const { return area.north_max - area.north_min; }
  [[nodiscard]] double east_extent() const { return area.east_max - area.east_min; }
  [[nodiscard]] Footprint footprint() const {
    return {{.altitude = altitude.number(), .object_height_max = band.number()}, camera};
  }
  /// Where the area is said: its line, or that of its northern edge.
  [[nodiscard]] const Setting& area_line() const {
    return outline.is_default ? north_max : outline;
  }
  /// How far a point is outside the area [m]; 0 inside. REQUIRES: no problem.
  [[nodiscard]] double Outside(const Eigen::Vector2d& p_W) const;
};

/// Nothing if the mission does not launch both pSurvey and pHelm.
[[nodiscard]] std::optional<SurveyFacts> ReadSurveyFacts(const MissionReading& reading);

/// Path that a survey needs at least [m]: lanes as wide as the image at the height that the target
/// counts, side by side without overlap, and the turns between them.
struct PathEstimate {
  double lanes_m = 0.0;
  double turns_m = 0.0;
  [[nodiscard]] double total() const { return lanes_m + turns_m; }
};
[[nodiscard]] PathEstimate EstimatePath(const SurveyFacts& survey, const std::string& coverage_kind,
                                        double coverage_target);

}  // namespace limpet
