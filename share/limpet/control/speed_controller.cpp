// SPDX-License-Identifier: MIT
#include "limpet/control/speed_controller.hpp"

#include <algorithm>

namespace limpet {

SpeedController::SpeedController(const Gains& gains, const Hydrodynamics& hydro)
    : gains_(gains), hydro_(hydro) {}

void SpeedController::Reset(double speed) {
  reference_ = speed;
  ramp_ = 0.0;
}

double SpeedController::Lack(const Input& input, double dt) {
  const double step = gains_.max_acceleration * dt;
  const double change = std::clamp(input.desired - reference_, -step, step);
  reference_ += change;
  ramp_ = dt > 0.0 ? change / dt : 0.0;
  return reference_ - input.speed;
}

double SpeedController::Force(const Demand& demand) const {
  return hydro_.mass_matrix(kSurge, kSurge) * (ramp_ + gains_.speed * demand.lack) +
         DragForce(hydro_, kSurge, reference_ - demand.current);
}

}  // namespace limpet
