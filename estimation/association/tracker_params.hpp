// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/association/box_gate.hpp"
#include "estimation/association/triangulation.hpp"

namespace limpet {

struct ObjectTrackerParams {
  ObjectModel model;
  BoxGateParams gate;
  CameraMountParams mount;
  double min_confidence = 0.45;  ///< boxes below are not used
  int looks_to_confirm = 3;
  double confirm_log_odds = 2.5;  ///< sum of ln(c / (1 - c)) over the observations' confidences
  double confirm_sd_m = 0.8;      ///< worst 1-sigma of the place, else more observations are needed
  double confirm_residual = 3.5;  ///< worst whitened residual of an observation
  double place_prior_m = 3.0;     ///< weak hold on a landmark where its first pose saw it
  double confirm_within_s = 20.0;
  double confirm_hit_share = 0.25;  ///< of the frames that should have shown it
  double drop_hit_share = 0.1;      ///< a landmark seen in fewer is a false one
  int drop_after_expected = 40;
  /// A box is taken for a landmark at once when the landmark was expected within this share of the
  /// box's size; else several boxes must first agree among themselves.
  double expected_within_share = 0.2;
  double known_margin = 10.0;     ///< -2 ln of the likelihood ratio that tells a known object
  double small_drift_m = 0.3;     ///< drift below which three boxes are enough for that
  double drift_share = 0.01;      ///< of the way since last seen, for tentative objects
  double outlier_sigma = 6.0;     ///< an observation that fits worse after solving is taken out
  double merge_distance_m = 2.5;  ///< landmarks further apart are never one
  double objects_per_m3 = 1e-3;   ///< how crowded the water is
  double pair_distance_m = 2.0;   ///< objects this near each other come in groups
};

}  // namespace limpet
