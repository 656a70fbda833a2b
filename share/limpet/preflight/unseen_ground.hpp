// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/planning/region.hpp"
#include "limpet/preflight/survey_facts.hpp"

namespace limpet {

/// Ground that is to be seen and cannot be: a share of it, and the place of it that is farthest
/// from where the vehicle may be.
struct UnseenShare {
  double share = 0.0;
  PlanePoint farthest_W = PlanePoint::Zero();
  bool is_start_shut_off = false;  ///< from where there is more room
};

/// About how much of the area's ground no image shows to the top of the band that a vehicle takes
/// which keeps to where full turns hang together, or are joined by straight passages: with where it
/// starts, if that is in the region.
/// Nothing if a turn fits nowhere. REQUIRES: a region with a free space.
[[nodiscard]] std::optional<UnseenShare> UnseenGround(const SurveyFacts& survey,
                                                      const Region& region,
                                                      const std::optional<PlanePoint>& start);

}  // namespace limpet
