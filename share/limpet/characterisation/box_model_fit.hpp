// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/characterisation/detector_trial.hpp"
#include "limpet/vision/box_model.hpp"

namespace limpet {

/// What a vehicle may believe of a detector: what was measured, with a margin, since no sea is what
/// was rendered.
struct DetectionSheet {
  double best = 0.97;             ///< chance per picture of a near, whole object
  double half_range_share = 1.1;  ///< of the visibility, where half of that is left
  double fall_off_share = 0.06;   ///< of the visibility, over which it falls
  double least_size_px = 17.0;    ///< diameter of which half are found
  double share_none = 0.2;        ///< visible share below which nothing is found
  double share_full = 0.6;        ///< and above which the border does not matter
  double false_per_image = 0.03;
  double wrong_color = 0.03;    ///< share of boxes that name another colour than the object's
  double color_penalty = 30.0;  ///< squared sigmas that another colour costs between sessions
};

/// Constants of BoxModel that make what was found of the balls likeliest, and the spread of their
/// boxes. REQUIRES: some ball was found.
[[nodiscard]] BoxModelConstants FitBoxModel(const TrialResult& trial);

/// `boxes` as a vehicle may believe it.
[[nodiscard]] DetectionSheet SheetOf(const BoxModelConstants& boxes, const TrialResult& trial);

}  // namespace limpet
