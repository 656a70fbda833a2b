// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Their rows, in SNAME's order.
inline constexpr int kSurge = 0, kSway = 1, kHeave = 2, kRoll = 3, kPitch = 4, kYaw = 5;

/// What the equations of motion need, derived once from the vehicle's constants.
struct Hydrodynamics {
  double weight_n = 0.0;
  double buoyancy_n = 0.0;     ///< fully submerged
  double half_height_m = 0.0;  ///< of the displaced ellipsoid
  Matrix6 mass_matrix;         ///< rigid body plus added mass, about the body origin
  Vector6 linear_drag;         ///< N per m/s, N m per rad/s
  Vector6 quadratic_drag;      ///< N per (m/s)^2, N m per (rad/s)^2
};

/// REQUIRES: MeanThickness(params) < params.length_m.
[[nodiscard]] Hydrodynamics DeriveHydrodynamics(const VehicleParams& params);
/// Diameter [m] of the spheroid that is as long and displaces as much.
[[nodiscard]] double MeanThickness(const VehicleParams& params);

/// Added mass of a prolate spheroid, as shares of its displaced mass and of its moment of inertia
/// (Lamb's k-factors; Fossen 2011 section 6.4.1, Imlay 1961).
struct SpheroidAddedMass {
  double axial = 0.0;       ///< k1: along the long axis
  double transverse = 0.0;  ///< k2
  double rotation = 0.0;    ///< k': about a short axis
};
struct Spheroid {
  double length = 1.0, diameter = 0.5;  ///< [m]
};
/// REQUIRES: 0 < diameter < length.
[[nodiscard]] SpheroidAddedMass LambFactors(const Spheroid& body);

/// Where the displaced ellipsoid is in the water.
struct Immersion {
  double depth = 0.0;        ///< of its centre [m]
  double half_height = 1.0;  ///< of itself [m]
};
/// Share of its volume that is under water: the cap of an ellipsoid, (2 + 3 z - z^3) / 4 with z =
/// depth / half_height in [-1, 1]. Once continuously differentiable.
[[nodiscard]] double SubmergedShare(const Immersion& ellipsoid);

/// Depth of the origin at which the vehicle floats level and at rest.
[[nodiscard]] double FloatingDepth(const Hydrodynamics& hydro);

/// Steady drag force [N] of surge, sway or heave (axis 0, 1, 2) at a speed through the water [m/s].
[[nodiscard]] double DragForce(const Hydrodynamics& hydro, int axis, double speed);

}  // namespace limpet
