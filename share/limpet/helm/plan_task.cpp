// SPDX-License-Identifier: MIT
#include "limpet/helm/plan_task.hpp"

namespace limpet {

MissionPlan::Task PlanTaskOf(const Situation& now, const SearchGoals& goals, double finish_share) {
  const GroundRates& rates = goals.objective.ground;
  const bool is_covering = rates.cover > 0.0;
  MissionPlan::Task task{.pose = now.pose,
                         .ground = now.ground,
                         .region = now.region,
                         .turn_radius = now.turn_radius,
                         .goal = {.finish_share = is_covering ? finish_share : 0.0,
                                  .home_W = now.next(),
                                  .course_cost = now.course_cost},
                         .travelled = now.travelled};
  if (!is_covering) return task;
  task.goal.early_weight = rates.early / rates.cover;
  task.goal.most_weight = rates.most / rates.cover;
  task.goal.others = goals.objective;
  task.goal.others_weight = 1.0 / rates.cover;
  return task;
}

}  // namespace limpet
