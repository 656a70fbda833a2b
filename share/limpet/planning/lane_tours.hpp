// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/planning/survey_tour.hpp"

namespace limpet {

struct LaneParams {
  int directions = 12;            ///< tried, over half a turn
  bool with_bottom_first = true;  ///< also lanes for the seabed, then the strips between them
};

/// Parallel passes over everything whose top `judge` has not seen, for several directions and
/// numbers of lanes, each in about the best order, cheapest first.
[[nodiscard]] std::vector<SurveyTour> LaneTours(TourJudge& judge, const LaneParams& params);

}  // namespace limpet
