// SPDX-License-Identifier: MIT
#include "limpet/control/heading_controller.hpp"

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

/// Farther off than this [rad] the vehicle is turning, not holding: nothing to learn for a bias.
constexpr double kHolding = 0.3;

}  // namespace

HeadingController::HeadingController(const Gains& gains, const Hydrodynamics& hydro)
    : gains_(gains),
      inertia_(hydro.mass_matrix(kYaw, kYaw)),
      hydro_(hydro),
      integral_({.gain = gains.integral, .limit = gains.integral_limit}) {}

double HeadingController::Update(const Input& input, double dt, bool is_saturated) {
  const double error = WrapAngle(input.desired_yaw - input.yaw);
  const double asked = std::clamp(gains_.heading * error, -gains_.max_rate, gains_.max_rate);
  const double wanted_rate = input.desired_turn_rate + asked;
  const double held = std::abs(error) < kHolding ? error : 0.0;
  const double acceleration = gains_.rate * (wanted_rate - input.yaw_rate) +
                              integral_.Update(held, Seconds(dt), is_saturated);
  // Fossen 2011 eq. 6.43: added masses of surge and sway differ.
  const double munk = (hydro_.mass_matrix(kSway, kSway) - hydro_.mass_matrix(kSurge, kSurge)) *
                      input.u_water * input.v_water;
  return inertia_ * acceleration + DragForce(hydro_, kYaw, wanted_rate) + munk;
}

}  // namespace limpet
