// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// Takes estimates to the true frame: turn by `yaw` about the vertical through `pivot_W`, then
/// shift.
struct CommonOffset {
  double yaw = 0.0;                                    ///< [rad]
  Eigen::Vector3d pivot_W = Eigen::Vector3d::Zero();   ///< of the estimates [m]
  Eigen::Vector3d target_W = Eigen::Vector3d::Zero();  ///< where the pivot truly is [m]
  [[nodiscard]] Eigen::Vector3d Apply(const Eigen::Vector3d& estimate_W) const;
};

/// Errors over time, from the start of the survey, for the figure.
struct NavErrorCurve {
  std::vector<double> time_s, path_m;
  std::vector<double> error_m;                  ///< 3-D, of the estimate
  std::vector<double> north_m, east_m, down_m;  ///< estimate less truth
  std::vector<double> sd_north_m, sd_east_m, sd_down_m;
  std::vector<double> dead_reckoning_time_s, dead_reckoning_m;  ///< 3-D
};

/// The estimate as known at the time against the truth, from the start of the survey. What nothing
/// was recorded for is left open.
struct NavScore {
  std::optional<double> position_rmse_m;
  /// After removing one horizontal and one vertical shift and one yaw.
  std::optional<double> aligned_rmse_m;
  /// At the end of the way under water, before the ascent and its new fixes; without an ascent at
  /// the end of the record.
  std::optional<double> final_error_m;
  std::optional<double> dead_reckoning_final_error_m;  ///< at the same moment
  /// Normalised estimation error squared [Bar-Shalom 2001], per degree of freedom times 3: 3 is
  /// consistent, more is overconfident.
  std::optional<double> nees_mean;
  CommonOffset offset;
  NavErrorCurve curve;
};

/// `start_s`: MOOS time of the survey's start.
[[nodiscard]] NavScore ScoreNavigation(const SessionRecord& record, double start_s);

}  // namespace limpet
