// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/mission/scenario.hpp"
#include "limpet/scoring/pose_track.hpp"

namespace limpet {

/// How near the vehicle truly came to something that it must not touch.
struct ObstacleScore {
  std::string name;
  double distance_m = 0.0;  ///< of the body's origin, least over the session; 0: it was inside
};

/// Every obstacle of the scenario, in its order. REQUIRES: a track that is not empty.
[[nodiscard]] std::vector<ObstacleScore> ScoreObstacles(const PoseTrack& truth,
                                                        const Scenario& scenario);

}  // namespace limpet
