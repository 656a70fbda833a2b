// SPDX-License-Identifier: MIT
#include "limpet/control/drift_estimate.hpp"

#include <cmath>

namespace limpet {

Eigen::Vector2d DriftEstimate::Update(double yaw, const Eigen::Vector2d& lack_B, double dt,
                                      bool is_saturated) {
  Eigen::Matrix2d R_WB;
  R_WB << std::cos(yaw), -std::sin(yaw), std::sin(yaw), std::cos(yaw);
  if (!is_saturated) {
    const Eigen::Vector2d step(gains_.along * lack_B.x(), gains_.across * lack_B.y());
    current_W_ -= dt * (R_WB * step);
    const double speed = current_W_.norm();
    if (speed > gains_.limit) current_W_ *= gains_.limit / speed;
  }
  return R_WB.transpose() * current_W_;
}

}  // namespace limpet
