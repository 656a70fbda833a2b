// SPDX-License-Identifier: MIT
#include "limpet/control/pilot.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/frames.hpp"

namespace limpet {

static_assert(ThrusterCommand::kMost == kMostThrusters);
namespace {

/// Share of the wanted speed for a vehicle with its bow so far up or down. Ahead and down together
/// pitch a light one up (Munk's moment), until what is meant to drive it ahead lifts it: then it
/// goes on once it has righted itself.
double ShareOfSpeedAt(double pitch) {
  constexpr double kLevel = 0.25, kSteep = 0.5;  // [rad]
  return std::clamp((kSteep - std::abs(pitch)) / (kSteep - kLevel), 0.0, 1.0);
}

}  // namespace

Pilot::Pilot(const Gains& gains, const VehicleParams& vehicle)
    : heading_(gains.heading, DeriveHydrodynamics(vehicle)),
      speed_(gains.speed, DeriveHydrodynamics(vehicle)),
      sway_(gains.sway, DeriveHydrodynamics(vehicle)),
      drift_(gains.drift),
      depth_(gains.depth, DeriveHydrodynamics(vehicle)),
      allocation_(vehicle.thrusters),
      thrusters_(vehicle.thrusters.thrusters.size()) {}

void Pilot::Reset(const NavState& nav) {
  heading_.Reset();
  speed_.Reset(nav.u);
  drift_.Reset();
  depth_.Reset(nav.down);
  is_saturated_ = false;
}

Eigen::Vector2d Pilot::HorizontalForce(const NavState& nav, const DesiredMotion& desired,
                                       double dt) {
  // Facing away from the wanted course, speed would only carry the vehicle off its path.
  const double facing = std::max(0.0, std::cos(WrapAngle(desired.yaw - nav.yaw)));
  if (!desired.speed) speed_.Reset(nav.u);
  const double share = facing * ShareOfSpeedAt(nav.pitch);
  double lack = desired.speed ? speed_.Lack({nav.u, share * *desired.speed}, dt) : 0.0;
  double v = nav.v;
  if (nav.velocity_age) lack = v = 0.0;  // held, not measured: feed forward alone, learn nothing
  current_B_ = drift_.Update(nav.yaw, {lack, -v}, dt, is_saturated_);
  const double sway = sway_.Force({.u = nav.u,
                                   .v = v,
                                   .turn_rate = nav.yaw_rate,
                                   .current_u = current_B_.x(),
                                   .current_v = current_B_.y()});
  return {desired.speed ? speed_.Force({.lack = lack, .current = current_B_.x()}) : 0.0, sway};
}

Wrench Pilot::WantedWrench(const NavState& nav, const DesiredMotion& desired, double dt) {
  Wrench wanted = Wrench::Zero();
  wanted.head<2>() = HorizontalForce(nav, desired, dt);
  wanted(2) = HeaveForce(nav, Meters(desired.depth), dt);
  wanted(5) = heading_.Update({.yaw = nav.yaw,
                               .yaw_rate = nav.yaw_rate,
                               .desired_yaw = desired.yaw,
                               .desired_turn_rate = desired.turn_rate,
                               .u_water = nav.u - current_B_.x(),
                               .v_water = -current_B_.y()},
                              dt, is_saturated_);
  return wanted;
}

double Pilot::HeaveForce(const NavState& nav, Meters depth, double dt) {
  const Eigen::Vector3d v_W = RotationOf(nav.pose()) * Eigen::Vector3d(nav.u, nav.v, nav.w);
  return depth_.Update({nav.down, v_W.z(), depth.value()}, dt, is_saturated_);
}

ThrusterCommand Pilot::Update(const NavState& nav, const DesiredMotion& desired, double dt) {
  return Allocate(WantedWrench(nav, desired, dt));
}

ThrusterCommand Pilot::Rise(const NavState& nav, double dt) {
  Wrench wanted = Wrench::Zero();
  wanted(2) = std::min(0.0, HeaveForce(nav, Meters(0.0), dt));
  return Allocate(wanted);
}

ThrusterCommand Pilot::Allocate(const Wrench& wanted) {
  const ThrustAllocation::Result result = allocation_.Allocate(wanted);
  is_saturated_ = result.is_saturated;
  return ThrusterCommand::Of({result.command.data(), thrusters_});
}

}  // namespace limpet
