// SPDX-License-Identifier: MIT
#include "apps/pPilot/speed_controller.hpp"

namespace limpet {
namespace {

constexpr int kSurge = 0;

}  // namespace

SpeedController::SpeedController(const Gains& gains, const Hydrodynamics& hydro)
    : gains_(gains), hydro_(hydro), integral_(gains.integral, gains.integral_limit) {}

void SpeedController::Reset(double speed) {
  integral_.Reset();
  reference_ = speed;
}

double SpeedController::Update(double speed, double desired_speed, double dt, bool is_saturated) {
  const double step = gains_.max_acceleration * dt;
  const double before = reference_;
  reference_ += std::clamp(desired_speed - reference_, -step, step);
  const double ramp = dt > 0.0 ? (reference_ - before) / dt : 0.0;
  const double error = reference_ - speed;
  const double acceleration =
      ramp + gains_.speed * error + integral_.Update(error, dt, is_saturated);
  return hydro_.mass_matrix(kSurge, kSurge) * acceleration + DragForce(hydro_, kSurge, reference_);
}

}  // namespace limpet
