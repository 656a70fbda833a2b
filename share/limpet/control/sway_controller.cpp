// SPDX-License-Identifier: MIT
#include "limpet/control/sway_controller.hpp"

#include <algorithm>

namespace limpet {

SwayController::SwayController(const Gains& gains, const Hydrodynamics& hydro)
    : gains_(gains), hydro_(hydro) {}

double SwayController::Force(const Input& input) const {
  const double m_u = hydro_.mass_matrix(kSurge, kSurge);
  const double m_v = hydro_.mass_matrix(kSway, kSway);
  // In sway the momentum of surge turns with the vehicle (Fossen 2011 eq. 6.43); and the current in
  // body axes turns the other way while its velocity over ground stays along the nose.
  const double through_water = input.u - input.current_u;
  const double turning = (m_u * through_water + m_v * input.current_u) * input.turn_rate;
  const double force =
      -m_v * gains_.speed * input.v + turning + DragForce(hydro_, kSway, -input.current_v);
  return std::clamp(force, -gains_.max_force, gains_.max_force);
}

}  // namespace limpet
