// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/helm/situation.hpp"
#include "limpet/planning/mission_plan.hpp"

namespace limpet {

/// What a plan of the whole mission is made for: where the vehicle stands, and what the behaviors
/// seek, in metres of path. Without a ground to cover nothing is left to plan.
[[nodiscard]] MissionPlan::Task PlanTaskOf(const Situation& now, const SearchGoals& goals,
                                           double finish_share);

}  // namespace limpet
