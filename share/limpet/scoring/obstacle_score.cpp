// SPDX-License-Identifier: MIT
#include "limpet/scoring/obstacle_score.hpp"

#include <algorithm>
#include <limits>

namespace limpet {

std::vector<ObstacleScore> ScoreObstacles(const PoseTrack& truth, const Scenario& scenario) {
  std::vector<ObstacleScore> scores;
  for (const ScenarioObstacle& obstacle : scenario.obstacles) {
    const UprightBody body = obstacle.Body(scenario.seabed);
    ObstacleScore score{.name = obstacle.name,
                        .distance_m = std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < truth.size(); ++i) {
      score.distance_m = std::min(score.distance_m, body.Distance(truth.position(i)));
    }
    scores.push_back(std::move(score));
  }
  return scores;
}

}  // namespace limpet
