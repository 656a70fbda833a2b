// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "limpet/characterisation/detector_trial.hpp"
#include "limpet/core/random.hpp"
#include "limpet/vision/box_model.hpp"

namespace limpet {

/// Looks at balls, found as `truth` says; sizes, ranges and borders drawn evenly.
inline TrialResult DrawTrial(const BoxModelConstants& truth, int looks, std::uint64_t seed) {
  Random random(seed, "drawn trial");
  const auto logistic = [](double x) { return 1.0 / (1.0 + std::exp(-x)); };
  TrialResult trial{.pictures = looks, .false_boxes = looks / 50, .looks = {}};
  for (int i = 0; i < looks; ++i) {
    TrialLook look;
    look.color = "yellow";
    look.visibility_m = 6.0;
    look.range = 6.0 * random.Uniform(0.1, 1.8);
    look.size_px = random.Uniform(5.0, 90.0);
    look.visible_fraction = random.Chance(0.5) ? 1.0 : random.Uniform(0.05, 1.0);
    look.visible = {100.0, 100.0, 100.0 + look.size_px, 100.0 + look.size_px};
    const double x = look.range_share();
    const double cut = 1.0 - look.visible_fraction;
    const double chance = truth.peak * logistic((truth.faint_at - x) / truth.faint_width) *
                          logistic((look.visible_fraction - truth.cut_at) / truth.cut_width) *
                          logistic((look.size_px - 2.0 * truth.least_radius_px) / 1.5);
    if (random.Chance(chance)) {
      const double growth =
          (1.0 + truth.sd_growth_faint * x * x) * (1.0 + truth.sd_growth_cut * cut);
      const double mean =
          truth.confidence - truth.confidence_loss_faint * x * x - truth.confidence_loss_cut * cut;
      look.found =
          Box{.u = look.visible.center_u() + random.Normal(truth.centre_sd_px * growth),
              .v = look.visible.center_v() + random.Normal(truth.centre_sd_px * growth),
              .w = look.size_px + truth.size_bias_px + random.Normal(truth.size_sd_px * growth),
              .h = look.size_px + truth.size_bias_px + random.Normal(truth.size_sd_px * growth),
              .confidence = std::clamp(mean + random.Normal(truth.confidence_sd), 0.0, 1.0),
              .color = random.Chance(truth.confusion_whole) ? "green" : "yellow"};
    }
    trial.looks.push_back(look);
  }
  return trial;
}

}  // namespace limpet
