// SPDX-License-Identifier: MIT
#include "limpet/control/depth_controller.hpp"

namespace limpet {

DepthController::DepthController(const Gains& gains, const Hydrodynamics& hydro)
    : gains_(gains),
      hydro_(hydro),
      integral_({.gain = gains.integral, .limit = gains.integral_limit}) {}

void DepthController::Reset(double depth) {
  integral_.Reset();
  reference_ = depth;
  reference_rate_ = 0.0;
}

double DepthController::MoveReference(const Input& input, double dt) {
  const double left = input.desired_depth - reference_;
  const double wanted_rate = std::clamp(gains_.approach * left, -gains_.max_rate, gains_.max_rate);
  const double step = gains_.max_acceleration * dt;
  const double change = std::clamp(wanted_rate - reference_rate_, -step, step);
  reference_rate_ += change;
  reference_ = std::clamp(reference_ + reference_rate_ * dt, input.depth - gains_.max_lead,
                          input.depth + gains_.max_lead);
  return dt > 0.0 ? change / dt : 0.0;
}

double DepthController::Update(const Input& input, double dt, bool is_saturated) {
  const bool stays_up = std::max(input.depth, input.desired_depth) < gains_.afloat_depth;
  if (stays_up) {
    Reset(input.depth);
    return 0.0;
  }
  const double reference_acceleration = MoveReference(input, dt);
  const double error = reference_ - input.depth;
  const double acceleration = reference_acceleration + gains_.depth * error +
                              gains_.rate * (reference_rate_ - input.depth_rate) +
                              integral_.Update(error, Seconds(dt), is_saturated);
  return hydro_.mass_matrix(kHeave, kHeave) * acceleration +
         DragForce(hydro_, kHeave, reference_rate_) + hydro_.buoyancy_n - hydro_.weight_n;
}

}  // namespace limpet
