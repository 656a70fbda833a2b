// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/planning/survey_tour.hpp"

namespace limpet {

struct LaneParams {
  int directions = 12;            ///< tried, over half a turn
  bool with_bottom_first = true;  ///< also lanes for the seabed, then the strips between them
};

/// `first`, and then parallel passes over everything whose top has not been seen by then, for
/// several directions and numbers of lanes, each in about the best order, cheapest first.
[[nodiscard]] std::vector<SurveyTour> LaneTours(TourJudge& judge, const LaneParams& params,
                                                const SurveyTour& first = {});

}  // namespace limpet
