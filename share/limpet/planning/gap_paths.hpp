// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/objective.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

struct GapParams {
  Meters turn_radius{3.0};
  Meters tile{4.0};  ///< patches are cut to this size
  int patches = 16;  ///< unseen patches tried, largest and nearest first
  int offers = 3;
  /// Crumbs may stay unseen: the largest patches are visited until this share of the band's top
  /// has been seen.
  double finish_share = 0.98;
  /// Patches smaller than this, mean over layers [m^2], are not worth a path of their own.
  double min_patch_m2 = 0.05;
};

/// Dubins paths through what is still unseen, wherever it is: for the end of a survey, when little
/// is left and a beam's horizon sees none of it. Best first; empty if all is seen.
[[nodiscard]] std::vector<Option> GapPaths(const Pose2& start, const Ground& ground,
                                           const Region& region, const Objective& objective,
                                           const GapParams& params);

}  // namespace limpet
