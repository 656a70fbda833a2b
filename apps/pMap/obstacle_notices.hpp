// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Obstacles as MOOS-IvP's behaviors take them: OBSTACLE_ALERT, which spawns or updates a
/// BHV_AvoidObstacle, and OBM_RESOLVED, which ends it.
class ObstacleNotices {
 public:
  struct News {
    std::vector<std::string> alerts;    ///< of those new, or with another outline
    std::vector<std::string> resolved;  ///< ids of those that are none any more
    std::vector<std::string> found;     ///< of those new, for people
  };
  /// What to say now that these are all there are.
  [[nodiscard]] News Of(const std::vector<Obstacle>& obstacles);

 private:
  std::vector<Obstacle> told_;
};

}  // namespace limpet
