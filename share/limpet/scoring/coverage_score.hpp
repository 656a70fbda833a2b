// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/mission/scenario.hpp"
#include "limpet/scoring/report_settings.hpp"
#include "limpet/scoring/session_record.hpp"
#include "limpet/scoring/unseen_places.hpp"

namespace limpet {

/// When a share was first reached; nothing if never. Both count from the start of the survey: what
/// the dive has shown counts, at no way and no time.
struct CoverageLevel {
  double level = 0.0;
  std::optional<double> path_m, time_s;
};

/// Shares after each camera frame, from the start of the survey, and by the dive before it.
struct CoverageCurve {
  std::vector<double> path_m, time_s, seabed, band;
};

/// What the camera has truly shown, from the true poses alone: on the dive, from where the vehicle
/// maps, and from there on.
struct CoverageScore {
  std::vector<CoverageLevel> seabed;  ///< 0.90, 0.95, 0.99
  std::vector<CoverageLevel> band;    ///< 0.90, 0.95, 0.99
  double covered = 0.0;               ///< share of the seabed at the end
  double detected_band = 0.0;         ///< share of the (point, height) samples at the end
  CoverageCurve curve;
  UnseenScore unseen;
  /// Way until every place of `former` has been in the image within visibility or within 1.5 m;
  /// what the dive has shown counts, at no way.
  std::optional<double> prior_opis_seen_path_m;
};

/// The camera's frames between the start of the survey and the ascent.
struct SurveyFrames {
  double start_s = 0.0;  ///< MOOS time at which the survey began
  double start_path_m = 0.0;
  std::vector<double> time_s;  ///< of each frame since the start
  std::vector<double> path_m;  ///< of each frame since the start
  std::vector<Pose> X_WB;
  std::vector<Pose> dive_X_WB;  ///< on the way down, before the start
};
/// Frames at multiples of the frame period of MOOS time; empty when the survey never began.
[[nodiscard]] SurveyFrames FramesOfSurvey(const SessionRecord& record,
                                          const ReportSettings& settings);

/// Coverage over the area of `record`; `former_W` are the true places of the former session's
/// objects.
[[nodiscard]] CoverageScore ScoreCoverage(const SurveyFrames& frames, const SurveyArea& area,
                                          const Scenario& scenario, const ReportSettings& settings,
                                          const std::vector<Eigen::Vector3d>& former_W);

}  // namespace limpet
