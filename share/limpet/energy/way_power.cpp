// SPDX-License-Identifier: MIT
#include "limpet/energy/way_power.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limpet {
namespace {

constexpr int kCourses = 24;

}  // namespace

WayPower::WayPower(const VehicleParams& vehicle, const BatterySheet& battery)
    : battery_(battery),
      hydro_(DeriveHydrodynamics(vehicle)),
      wrench_per_thrust_(vehicle.thrusters.WrenchPerThrust()),
      max_thrust_n_(vehicle.thrusters.max_thrust_n),
      net_buoyancy_n_(vehicle.net_buoyancy_n) {}

ThrusterVector WayPower::ThrustsFor(int axis, double force_n) const {
  const auto push = wrench_per_thrust_.row(axis);
  const double together = push.cwiseAbs().sum();
  const auto along = (push.array().abs() > 0.0).select(push.array().sign(), 0.0);
  return along.matrix().transpose() * (force_n / together);
}

double WayPower::Through(const Eigen::Vector2d& velocity_B) const {
  const ThrusterVector thrusts = ThrustsFor(kSurge, DragForce(hydro_, kSurge, velocity_B.x())) +
                                 ThrustsFor(kSway, DragForce(hydro_, kSway, velocity_B.y())) +
                                 ThrustsFor(kHeave, net_buoyancy_n_);
  if (thrusts.cwiseAbs().maxCoeff() > max_thrust_n_) return std::numeric_limits<double>::infinity();
  double power_w = battery_.hotel_w;
  for (const double thrust_n : thrusts)
    power_w += battery_.ThrusterPower(thrust_n / max_thrust_n_);
  return power_w;
}

double WayPower::Cruising(MetersPerSecond speed) const { return Through({speed.value(), 0.0}); }

double WayPower::AtRest() const { return Through({0.0, 0.0}); }

double WayPower::In(const WaterCurrent& current, const Way& way) const {
  const double cos = std::cos(way.course), sin = std::sin(way.course);
  return Through({way.speed.value() - (current.north * cos + current.east * sin),
                  current.north * sin - current.east * cos});
}

double WayPower::CostOf(const WaterCurrent& current, const Way& way) const {
  return std::min(kDearest, In(current, way) / Cruising(way.speed));
}

CourseCost WayPower::CostsOf(const WaterCurrent& current, MetersPerSecond speed) const {
  CourseCost costs;
  for (int i = 0; i < kCourses; ++i) {
    const double course = 2.0 * std::numbers::pi * i / kCourses;
    costs.metres.push_back(CostOf(current, {.course = course, .speed = speed}));
  }
  return costs;
}

}  // namespace limpet
