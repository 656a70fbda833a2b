// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limpet/core/random.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// Views drawn per node of a tree's budget before the tree stays as small as it is: [Bucci 2025],
/// Algorithm 3, recurses without bound when it is trapped at the border.
inline constexpr int kDrawsPerNode = 20;

/// Kernel density of the seen ground on a coarse grid (Gaussian, sigma a third of the swath): where
/// a new view is worth least.
class SeenDensity {
 public:
  explicit SeenDensity(const Ground& ground);
  /// Density at a place, 0 (nothing seen near by) to 1 (the most seen place).
  [[nodiscard]] double At(const Eigen::Vector2d& p_W) const;
  /// A pose inside the region, accepted with probability 1 - At; bounded: after `tries` the last
  /// one drawn.
  [[nodiscard]] Pose2 Sample(const Region& region, Random& random, int tries = 32) const;

 private:
  bool is_part_;  ///< views are sampled about this part of the ground
  double north_min_, east_min_, cell_m_;
  int rows_, columns_;
  std::vector<double> density_;
};

}  // namespace limpet
