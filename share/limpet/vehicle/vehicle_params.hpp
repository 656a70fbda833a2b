// SPDX-License-Identifier: MIT
// What a vehicle's model is made of. A vehicle's file (share/vehicles) says it; the defaults are of
// a FeelHippo-class vehicle and stand for what a file leaves out. They are estimates: published
// mass (35 kg), size (about 0.6 m), number of thrusters (6) and top speed (about 1 m/s) are met;
// the rest follows from the formulae named at each entry (Fossen 2011).
#pragma once

#include <array>

#include <Eigen/Core>

#include "limpet/core/gravity.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"
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

  template <class V>
  void Describe(V& visit) {
    visit("skid_fore_starboard_m", skids_B[0], "m",
          "Where the skid fore and to starboard touches the seabed, from the body origin",
          InRange(-5.0, 5.0));
    visit("skid_fore_port_m", skids_B[1], "m", "Where the skid fore and to port touches it",
          InRange(-5.0, 5.0));
    visit("skid_aft_starboard_m", skids_B[2], "m", "Where the skid aft and to starboard touches it",
          InRange(-5.0, 5.0));
    visit("skid_aft_port_m", skids_B[3], "m", "Where the skid aft and to port touches it",
          InRange(-5.0, 5.0));
    visit("skid_stiffness_n_per_m", stiffness_n_per_m, "Of each skid on the seabed [N/m]",
          InRange(10.0, 1e6));
    visit("skid_friction", friction, "Coefficient of friction on the seabed", InRange(0.0, 2.0));
  }
};

/// Body origin is the centre of buoyancy; axes forward-right-down; SI units.
struct VehicleParams {
  double gravity = kGravity;  ///< [m/s^2]
  double water_density = 1025.0;
  double mass = 35.0;
  double net_buoyancy_n = 3.0;     ///< 0.9 % of the weight: a dead vehicle surfaces
  double length_m = 0.6;           ///< of the displaced ellipsoid, whose height follows from the
  double width_m = 0.36;           ///< displaced volume (about 0.30 m)
  MetersPerSecond top_speed{1.0};  ///< through the water
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

  /// Hull and ballast.
  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("mass_kg", mass, "Dry mass with ballast [kg]", InRange(0.5, 20000.0));
    visit("net_buoyancy_n", net_buoyancy_n, "Buoyancy less weight: a dead vehicle must rise [N]",
          InRange(0.01, 1000.0));
    visit("length_m", length_m, "Of the displaced ellipsoid [m]", InRange(0.1, 20.0));
    visit("width_m", width_m, "Of the displaced ellipsoid; its height follows from the mass [m]",
          InRange(0.05, 10.0));
    visit("top_speed_mps", top_speed,
          "What it can do through the water, whatever it is told: while nothing measures its "
          "velocity, pNav's sigma grows by it",
          InRange(0.05_mps, 10.0_mps));
    visit("cg_below_cb_m", cg_below_cb_m, "Centre of gravity below that of buoyancy [m]",
          InRange(0.001, 2.0));
    visit("inertia_factor", inertia_factor, "Moments of inertia over those of a solid ellipsoid",
          InRange(0.2, 5.0));
    visit("frame_added_mass", frame_added_mass,
          "Share of the dry inertia that frame, ducts and skids drag along", InRange(0.0, 2.0));
    visit("drag_coefficient", drag_coefficient, "",
          "Surge, sway and heave, on the ellipsoid's projected areas", InRange(0.05, 5.0));
    visit("linear_drag_speed_mps", linear_drag_speed_mps,
          "Speed at which linear and quadratic drag are equal [m/s]", InRange(0.0, 2.0));
    visit("rotation_drag_factor", rotation_drag_factor, "Rotational drag over that of strip theory",
          InRange(0.1, 20.0));
    visit("linear_drag_rate_radps", linear_drag_rate_radps,
          "Turn rate at which linear and quadratic drag are equal [rad/s]", InRange(0.0, 10.0));
    visit("antenna_m", antenna_B, "m", "GPS antenna, from the body origin", InRange(-10.0, 10.0));
    visit("surfaced_depth_m", surfaced_depth_m, "Origin shallower than this: surfaced [m]",
          InRange(0.0, 5.0));
    visit("submerged_depth_m", submerged_depth_m,
          "Origin deeper than this: submerged, antenna under water [m]", InRange(0.0, 5.0));
    contact.Describe(visit);
  }
};

}  // namespace limpet
