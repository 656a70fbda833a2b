// SPDX-License-Identifier: MIT
#include "estimation/navigation/driven_speed.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr double kStep = 0.1;      // [s]
constexpr double kLongest = 60.0;  // [s] after which a vehicle without thrust is at rest

}  // namespace

void DrivenSpeed::AddForce(double t, const Eigen::Vector2d& force_B, double yaw_rate) {
  if (!std::isfinite(t) || !force_B.allFinite() || (!knots_.empty() && t <= knots_.back().t)) {
    return;
  }
  const Eigen::Vector2d v_B =
      knots_.empty() ? Eigen::Vector2d(Eigen::Vector2d::Zero()) : After(knots_.back(), t);
  knots_.push_back({.t = t, .v_B = v_B, .force_B = force_B, .yaw_rate = yaw_rate});
}

void DrivenSpeed::AddCommand(const ThrusterShares& command, double yaw_rate) {
  if (!params_.full_thrust_B) return;
  const Eigen::Map<const Eigen::Matrix<double, FullThrust::ColsAtCompileTime, 1>> shares(
      command.shares.data());
  AddForce(command.t, *params_.full_thrust_B * shares.cwiseMax(-1.0).cwiseMin(1.0), yaw_rate);
}

std::optional<Eigen::Vector2d> DrivenSpeed::At(double t) const {
  if (knots_.empty()) return std::nullopt;
  const auto is_later = [t](const Knot& knot) { return knot.t > t; };
  const auto before = std::find_if_not(knots_.rbegin(), knots_.rend(), is_later);
  return before == knots_.rend() ? Eigen::Vector2d(Eigen::Vector2d::Zero()) : After(*before, t);
}

void DrivenSpeed::DropBefore(double t) {
  while (knots_.size() > 1 && knots_[1].t < t) {
    knots_.pop_front();
  }
}

Eigen::Vector2d DrivenSpeed::After(const Knot& knot, double t) const {
  const double lasts = params_.command_lasts.value(), age = t - knot.t;
  Eigen::Vector2d v_B = Pushed(knot, std::min(age, lasts));
  if (age <= lasts) return v_B;
  const Knot stopped{.t = knot.t + lasts, .v_B = v_B, .yaw_rate = knot.yaw_rate};
  return Pushed(stopped, std::min(age - lasts, kLongest));
}

Eigen::Vector2d DrivenSpeed::Pushed(const Knot& knot, double seconds) const {
  const int steps = std::max(1, static_cast<int>(std::ceil(seconds / kStep)));
  const double dt = std::max(seconds, 0.0) / steps;
  Eigen::Vector2d v_B = knot.v_B;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d momentum = params_.mass_B.cwiseProduct(v_B);
    const Eigen::Vector2d turned = knot.yaw_rate * Eigen::Vector2d(momentum.y(), -momentum.x());
    const Eigen::Vector2d drag =
        params_.linear_drag_B + params_.quadratic_drag_B.cwiseProduct(v_B.cwiseAbs());
    // Implicit in the drag: stable however light the hull is.
    v_B = (momentum + dt * (knot.force_B + turned)).cwiseQuotient(params_.mass_B + dt * drag);
  }
  return v_B;
}

}  // namespace limpet
