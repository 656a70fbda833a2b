// SPDX-License-Identifier: MIT
#include "limpet/vehicle/hydrodynamics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/cross_product.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Moments of inertia of a solid ellipsoid of half axes `half` per unit of mass.
Vector3d EllipsoidInertia(const Vector3d& half) {
  const Vector3d s = half.cwiseProduct(half);
  return Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()) / 5.0;
}

/// Rigid-body inertia about the body origin (Fossen 2011 eq. 3.44), centre of gravity below it.
Matrix6 RigidBodyMass(const VehicleParams& params, const Vector3d& inertia) {
  const Matrix3d lever = params.mass * CrossMatrixOf({0.0, 0.0, params.cg_below_cb_m});
  Matrix6 M = Matrix6::Zero();
  M.topLeftCorner<3, 3>() = params.mass * Matrix3d::Identity();
  M.topRightCorner<3, 3>() = -lever;
  M.bottomLeftCorner<3, 3>() = lever;
  M.bottomRightCorner<3, 3>() = inertia.asDiagonal();
  const double steiner = params.mass * params.cg_below_cb_m * params.cg_below_cb_m;
  M(3, 3) += steiner;
  M(4, 4) += steiner;
  return M;
}

/// Half axes [m] of the ellipsoid that is as long and wide and displaces as much as the vehicle.
Vector3d HalfAxes(const VehicleParams& params) {
  const double displaced_mass =
      (params.mass * params.gravity + params.net_buoyancy_n) / params.gravity;
  const double a = 0.5 * params.length_m;
  const double b = 0.5 * params.width_m;
  return {a, b, displaced_mass / params.water_density / (4.0 / 3.0 * std::numbers::pi * a * b)};
}

double MeanDiameter(const Vector3d& half) { return 2.0 * std::sqrt(half.y() * half.z()); }

Vector6 AddedMass(const VehicleParams& params, const Vector3d& half, const Vector3d& inertia,
                  double displaced_mass) {
  const SpheroidAddedMass k =
      LambFactors({.length = 2.0 * half.x(), .diameter = MeanDiameter(half)});
  const Vector3d solid = displaced_mass * EllipsoidInertia(half);
  Vector6 added;
  added << displaced_mass * k.axial, displaced_mass * k.transverse, displaced_mass * k.transverse,
      0.0, k.rotation * solid.y(), k.rotation * solid.z();
  added.head<3>().array() += params.frame_added_mass * params.mass;
  added.tail<3>() += params.frame_added_mass * inertia;
  return added;
}

/// Quadratic drag: 1/2 rho Cd A for forces; for moments the cross-flow on strips of the projected
/// ellipse, 1/2 rho Cd * integral of 2 b sqrt(1 - (x/a)^2) |x|^3 dx = 1/2 rho Cd * 8/15 a^4 b
/// (Fossen 2011 section 6.4.3).
Vector6 QuadraticDrag(const VehicleParams& params, const Vector3d& half) {
  const double half_rho = 0.5 * params.water_density;
  const Vector3d area =
      std::numbers::pi * Vector3d(half.y() * half.z(), half.x() * half.z(), half.x() * half.y());
  const auto strips = [&](double arm, double breadth) {
    return half_rho * params.rotation_drag_factor * 8.0 / 15.0 * std::pow(arm, 4) * breadth;
  };
  const Vector3d& cd = params.drag_coefficient;
  Vector6 drag;
  drag << half_rho * cd.cwiseProduct(area), cd.z() * strips(half.y(), half.x()),
      cd.z() * strips(half.x(), half.y()), cd.y() * strips(half.x(), half.z());
  return drag;
}

}  // namespace

SpheroidAddedMass LambFactors(const Spheroid& body) {
  const auto [length, diameter] = body;
  LIMPET_REQUIRE(0.0 < diameter && diameter < length, "a prolate spheroid is longer than thick");
  const double slender = diameter * diameter / (length * length);
  const double e2 = 1.0 - slender;
  const double e = std::sqrt(e2);
  const double log_term = std::log((1.0 + e) / (1.0 - e));
  const double alpha = 2.0 * slender / (e2 * e) * (0.5 * log_term - e);
  const double beta = 1.0 / e2 - slender / (2.0 * e2 * e) * log_term;
  const double e4 = e2 * e2;
  return {
      .axial = alpha / (2.0 - alpha),
      .transverse = beta / (2.0 - beta),
      .rotation = e4 * (beta - alpha) / ((2.0 - e2) * (2.0 * e2 - (2.0 - e2) * (beta - alpha)))};
}

Hydrodynamics DeriveHydrodynamics(const VehicleParams& params) {
  Hydrodynamics hydro;
  hydro.weight_n = params.mass * params.gravity;
  hydro.buoyancy_n = hydro.weight_n + params.net_buoyancy_n;
  const double displaced_mass = hydro.buoyancy_n / params.gravity;
  const Vector3d half = HalfAxes(params);
  hydro.half_height_m = half.z();
  const Vector3d inertia = params.inertia_factor * params.mass * EllipsoidInertia(half);
  hydro.mass_matrix = RigidBodyMass(params, inertia);
  hydro.mass_matrix.diagonal() += AddedMass(params, half, inertia, displaced_mass);
  hydro.quadratic_drag = QuadraticDrag(params, half);
  hydro.linear_drag << params.linear_drag_speed_mps * hydro.quadratic_drag.head<3>(),
      params.linear_drag_rate_radps * hydro.quadratic_drag.tail<3>();
  return hydro;
}

double MeanThickness(const VehicleParams& params) { return MeanDiameter(HalfAxes(params)); }

double SubmergedShare(const Immersion& ellipsoid) {
  const double z = std::clamp(ellipsoid.depth / ellipsoid.half_height, -1.0, 1.0);
  return 0.25 * (2.0 + z * (3.0 - z * z));
}

double FloatingDepth(const Hydrodynamics& hydro) {
  double low = -hydro.half_height_m;
  double high = hydro.half_height_m;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const bool sinks =
        hydro.buoyancy_n * SubmergedShare({.depth = middle, .half_height = hydro.half_height_m}) <
        hydro.weight_n;
    (sinks ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double DragForce(const Hydrodynamics& hydro, int axis, double speed) {
  return hydro.linear_drag(axis) * speed + hydro.quadratic_drag(axis) * std::abs(speed) * speed;
}

}  // namespace limpet
