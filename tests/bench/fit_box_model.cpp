// SPDX-License-Identifier: MIT
// Renders random frames of the plain look, runs the detector, and prints the constants of
// BoxModelConstants that describe what it achieved.
// Usage: fit_box_model [scenes of 20 frames, default 150] [seed]
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "limpet/characterisation/detector_sheet.hpp"
#include "tests/support/detector_trial.hpp"

namespace limpet {
namespace {

/// Frames of balls only; those that overlap are not in it.
TrialResult ToTrialResult(const trial::Result& result) {
  TrialResult all{.pictures = result.frames, .false_boxes = result.false_boxes, .looks = {}};
  for (const trial::Look& look : result.looks) {
    all.looks.push_back({.kind = SolidKind::kSphere,
                         .color = look.color,
                         .range = look.image.range,
                         .visibility_m = look.visibility_m,
                         .size_px = std::sqrt(look.image.outline.area()),
                         .visible_fraction = look.image.visible_fraction,
                         .visible = look.image.visible,
                         .found = look.found});
  }
  return all;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  limpet::trial::Plan plan{.scenes = 150, .frames = 20, .least_visibility_m = 2.5};
  if (argc > 1) plan.scenes = std::max(1, std::atoi(argv[1]));
  if (argc > 2) plan.seed = static_cast<std::uint64_t>(std::max(1, std::atoi(argv[2])));
  const limpet::TrialResult trial = limpet::ToTrialResult(limpet::trial::RunDetector(plan));
  fmt::print("{}", limpet::DetectorSheetText({.detector = plan.detector,
                                              .made_with = "fit_box_model",
                                              .file = plan.detector + ".yaml"},
                                             trial));
  return 0;
}
