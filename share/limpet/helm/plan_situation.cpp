// SPDX-License-Identifier: MIT
#include "limpet/helm/plan_situation.hpp"

namespace limpet {

MissionPlan::Situation PlanSituationOf(const Situation& now, const SearchGoals& goals,
                                       double finish_share) {
  const GroundRates& rates = goals.objective.ground;
  const bool is_covering = rates.cover > 0.0;
  MissionPlan::Situation situation{.pose = now.pose,
                                   .ground = now.ground,
                                   .region = now.region,
                                   .turn_radius = now.turn_radius,
                                   .goal = {.finish_share = is_covering ? finish_share : 0.0,
                                            .home = {now.home.north, now.home.east},
                                            .target_decay_m = goals.objective.target_decay_m},
                                   .travelled = now.travelled};
  if (!is_covering) return situation;
  situation.goal.early_weight = rates.early / rates.cover;
  situation.goal.targets = goals.objective.targets;
  for (Target& target : situation.goal.targets) {
    target.value /= rates.cover;
  }
  return situation;
}

}  // namespace limpet
