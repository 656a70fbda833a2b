// SPDX-License-Identifier: MIT
#include "estimation/mapping/ground_slope.hpp"

#include <vector>

#include <Eigen/Cholesky>

namespace limpet {
namespace {

/// 30 degrees: what is steeper is no seabed to fly over but a wall.
constexpr double kSteepestCredible = 0.58;
/// Share that each new ping has in the slope that is believed: two seconds of pings.
constexpr double kShare = 0.1;

}  // namespace

void GroundSlope::Add(const Pose& X_WD, const std::array<std::optional<double>, 4>& ranges,
                      const DvlBeams& dvl) {
  const std::vector<BeamEnd> ends = BeamEnds(X_WD, ranges, 3.0, dvl);
  if (ends.size() < 3) return;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const BeamEnd& end : ends) {
    mean += end.p_W / static_cast<double>(ends.size());
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  for (const BeamEnd& end : ends) {
    const Eigen::Vector3d off = end.p_W - mean;
    spread += off.head<2>() * off.head<2>().transpose();
    tilt += off.head<2>() * off.z();
  }
  const Eigen::Vector2d slope = spread.ldlt().solve(tilt);
  if (!slope.allFinite()) return;
  const Eigen::Vector2d credible = slope.cwiseMax(-kSteepestCredible).cwiseMin(kSteepestCredible);
  slope_ += (is_known_ ? kShare : 1.0) * (credible - slope_);
  below_W_ = mean;
  is_known_ = true;
}

std::optional<double> GroundSlope::DepthAt(const Eigen::Vector2d& p_W) const {
  if (!is_known_) return std::nullopt;
  return below_W_.z() + slope_.dot(p_W - below_W_.head<2>());
}

}  // namespace limpet
