// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/characterisation/detector_trial.hpp"
#include "limpet/objects/detection_model.hpp"
#include "limpet/vision/box_model.hpp"

namespace limpet {

/// What a vehicle may believe of a detector: what was measured, with a margin, since no sea is what
/// was rendered.
struct DetectionSheet {
  DetectionModel detection;     ///< but for the visibility, which is the water's
  double wrong_color = 0.03;    ///< share of boxes that name another colour than the object's
  double color_penalty = 30.0;  ///< squared sigmas that another colour costs between sessions
};

/// Constants of BoxModel that make what was found of the balls likeliest, and the spread of their
/// boxes. REQUIRES: some ball was found.
[[nodiscard]] BoxModelConstants FitBoxModel(const TrialResult& trial);

/// `boxes` as a vehicle may believe it.
[[nodiscard]] DetectionSheet SheetOf(const BoxModelConstants& boxes, const TrialResult& trial);

}  // namespace limpet
