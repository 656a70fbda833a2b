// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/planning/survey_tour.hpp"

namespace limpet {

/// The passes in the order, each in the direction, that makes the shortest way from `start`
/// through all of them and home: exact for up to a dozen (Held and Karp's dynamic program over
/// subsets), else by PlanPassTour.
[[nodiscard]] SurveyTour InBestOrder(const TourJudge& judge, const Pose2& start,
                                     const std::vector<Pass>& passes);

}  // namespace limpet
