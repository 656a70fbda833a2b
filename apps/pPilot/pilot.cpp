// SPDX-License-Identifier: MIT
#include "apps/pPilot/pilot.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/frames.hpp"

namespace limpet {

Pilot::Pilot(const Gains& gains, const VehicleParams& vehicle)
    : heading_(gains.heading, DeriveHydrodynamics(vehicle)),
      speed_(gains.speed, DeriveHydrodynamics(vehicle)),
      sway_(gains.sway, DeriveHydrodynamics(vehicle)),
      depth_(gains.depth, DeriveHydrodynamics(vehicle)),
      allocation_(vehicle.thrusters) {}

void Pilot::Reset(const NavState& nav) {
  heading_.Reset();
  speed_.Reset(nav.u);
  sway_.Reset();
  depth_.Reset(nav.down);
  is_saturated_ = false;
}

Wrench Pilot::WantedWrench(const NavState& nav, const DesiredMotion& desired, double dt) {
  const Eigen::Vector3d v_W = RotationOf(nav.pose()) * Eigen::Vector3d(nav.u, nav.v, nav.w);
  // Facing away from the wanted course, speed would only carry the vehicle off its path.
  const double facing = std::max(0.0, std::cos(WrapAngle(desired.yaw - nav.yaw)));
  Wrench wanted = Wrench::Zero();
  wanted(0) = speed_.Update(nav.u, facing * desired.speed, dt, is_saturated_);
  wanted(1) = sway_.Update({nav.u, nav.v, desired.turn_rate}, dt, is_saturated_);
  wanted(2) = depth_.Update({nav.down, v_W.z(), desired.depth}, dt, is_saturated_);
  wanted(5) =
      heading_.Update({nav.yaw, nav.yaw_rate, desired.yaw, desired.turn_rate}, dt, is_saturated_);
  return wanted;
}

ThrusterCommand Pilot::Update(const NavState& nav, const DesiredMotion& desired, double dt) {
  const ThrustAllocation::Result result = allocation_.Allocate(WantedWrench(nav, desired, dt));
  is_saturated_ = result.is_saturated;
  const ThrusterVector& c = result.command;
  return {.t1 = c(0), .t2 = c(1), .t3 = c(2), .t4 = c(3), .t5 = c(4), .t6 = c(5)};
}

}  // namespace limpet
