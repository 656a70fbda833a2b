// SPDX-License-Identifier: MIT
#include "apps/pPilot/sway_controller.hpp"

namespace limpet {

SwayController::SwayController(const Gains& gains, const Hydrodynamics& hydro)
    : gains_(gains), hydro_(hydro), integral_(gains.integral, gains.integral_limit) {}

double SwayController::Update(const Input& input, double dt, bool is_saturated) {
  const double acceleration =
      -gains_.speed * input.v + integral_.Update(-input.v, dt, is_saturated);
  // Fossen 2011 eq. 6.43: in sway, surge momentum turns with the vehicle.
  const double centripetal = hydro_.mass_matrix(0, 0) * input.u * input.turn_rate;
  const double force = hydro_.mass_matrix(1, 1) * acceleration + centripetal;
  return std::clamp(force, -gains_.max_force, gains_.max_force);
}

}  // namespace limpet
