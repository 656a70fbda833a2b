// SPDX-License-Identifier: MIT
// Constants of a FeelHippo-class vehicle. They are estimates: published mass (35 kg), size
// (about 0.6 m), number of thrusters (6) and top speed (about 1 m/s) are met; the rest follows from
// the formulae named at each entry (Fossen 2011, Handbook of Marine Craft Hydrodynamics).
#pragma once

#include <array>

#include <Eigen/Core>

#include "limpet/vehicle/thruster_layout.hpp"

namespace limpet {

/// What the seabed does to the four skids. Forces are smooth: a solver must not meet a kink.
struct ContactParams {
  double softness_m = 0.004;          ///< width w of the softplus penetration w ln(1 + exp(d / w))
  double stiffness_n_per_m = 3000.0;  ///< per skid; 20 N of down thrust sinks 2 mm
  double damping_s_per_m =
      2.0;                ///< Hunt-Crossley: normal force times (1 + damping * closing speed)
  double friction = 0.4;  ///< plastic on sand
  double friction_speed_mps = 0.01;  ///< friction is viscous below this sliding speed
  std::array<Eigen::Vector3d, 4> skids_B = {Eigen::Vector3d{0.25, 0.15, 0.2},
                                            {0.25, -0.15, 0.2},
                                            {-0.25, 0.15, 0.2},
                                            {-0.25, -0.15, 0.2}};
};

/// Body origin is the centre of buoyancy; axes forward-right-down; SI units.
struct VehicleParams {
  double gravity = 9.81;
  double water_density = 1025.0;
  double mass = 35.0;
  double net_buoyancy_n = 3.0;  ///< 0.9 % of the weight: a dead vehicle surfaces
  double length_m = 0.6;        ///< of the displaced ellipsoid, whose height follows from the
  double width_m = 0.36;        ///< displaced volume (about 0.30 m)
  double cg_below_cb_m =
      0.05;  ///< metacentric height: 17 N m/rad, above the Munk moment in pitch at full speed
  double inertia_factor = 1.3;     ///< masses sit nearer the shell than in a solid ellipsoid
  double frame_added_mass = 0.05;  ///< share of the dry inertia that open frame, ducts and skids
                                   ///< drag along, on top of the ellipsoid's added mass
  /// Drag coefficients on the ellipsoid's projected areas, surge, sway, heave: a blunt body with
  /// ducts and frame (Hoerner 1965: 0.5 to 1.2).
  Eigen::Vector3d drag_coefficient{0.7, 1.1, 1.1};
  /// Speed at which linear and quadratic drag are equal: skin friction matters below it.
  double linear_drag_speed_mps = 0.1;
  /// Strip theory underrates the rotational drag of a body with ducts at its corners.
  double rotation_drag_factor = 2.0;
  double linear_drag_rate_radps = 1.5;  ///< as linear_drag_speed_mps, for rotation

  Eigen::Vector3d antenna_B{0.0, 0.0, -0.25};  ///< GPS antenna, on a short mast
  double surfaced_depth_m = 0.18;   ///< origin shallower than this: surfaced (it floats at 0.13)
  double submerged_depth_m = 0.25;  ///< origin deeper than this: submerged, and antenna under water
  double touch_clearance_m = 0.05;  ///< event ahead of contact: never a root on a force
  double leave_clearance_m = 0.10;

  ThrusterLayout thrusters;
  ContactParams contact;
};

}  // namespace limpet
