// SPDX-License-Identifier: MIT
#include "limpet/simulation/tidal_current.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace limpet {

TidalCurrent::TidalCurrent(const TidalCurrentParams& params, const Eigen::Vector2d& mean_W,
                           Random random)
    : params_(params),
      mean_W_(mean_W),
      random_(random),
      north_(params.unrest_share * mean_W.norm(), params.unrest),
      east_(params.unrest_share * mean_W.norm(), params.unrest) {
  if (params_.tide_period > Seconds(0.0)) {
    phase_ = random_.Uniform(-std::numbers::pi, std::numbers::pi);
  }
}

Eigen::Vector2d TidalCurrent::At(Seconds now, double depth) {
  Eigen::Vector2d current = mean_W_;
  double turn = RadiansFromDegrees(params_.turn_deg_per_m) * std::max(depth, 0.0);
  if (params_.tide_period > Seconds(0.0)) {
    const double angle = 2.0 * std::numbers::pi * (now / params_.tide_period) + phase_;
    current *= 1.0 + params_.tide_share * std::cos(angle);
    turn += params_.tide_swing.value() * std::sin(angle);
  }
  if (turn != 0.0) current = Eigen::Rotation2Dd(turn) * current;
  if (params_.unrest_share > 0.0) {
    current.x() += north_.Sample(now, random_);
    current.y() += east_.Sample(now, random_);
  }
  return current * std::clamp(1.0 - params_.shear_per_m * depth, 0.0, 1.0);
}

}  // namespace limpet
