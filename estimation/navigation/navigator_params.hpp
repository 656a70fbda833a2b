// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/association/object_tracker.hpp"
#include "estimation/matching/session_matching.hpp"
#include "estimation/navigation/compass.hpp"
#include "estimation/navigation/odometry_track.hpp"
#include "estimation/navigation/velocity_gate.hpp"
#include "estimation/smoothing/arrow_smoother.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

struct NavigatorParams {
  OdometryParams odometry;
  VelocityGateParams velocity_gate;
  CompassParams compass;
  CameraModel camera;
  ObjectTrackerParams objects;
  ArrowParams smoother{.converged_decrease = 1e-6};
  Seconds frame_wait{0.6};         ///< boxes of a frame are waited for this long after its exposure
  Seconds node_period{1.0};        ///< longest time between poses of the chain
  Meters node_distance{0.5};       ///< longest way between them
  Meters depth_sigma{0.015};       ///< of the depths of one second together, bias included
  Meters depth_bias_sigma{0.15};   ///< of its zero and the air's pressure; 0: not estimated
  double depth_bias_drift = 0.05;  ///< 1-sigma of how that changes within an hour [m]
  /// Depth of the body origin where fixes come, with its 1-sigma.
  Meters surface_depth{0.13}, surface_depth_sigma{0.087};
  Eigen::Vector3d antenna_B = Eigen::Vector3d::Zero();  ///< lever arm of the GPS antenna [m]
  Radians tilt_sigma{0.0047};
  Meters start_sigma{5.0};          ///< of the first position, before any fix
  Seconds errors_period{1800.0};    ///< slow errors of the odometry are estimated anew after this
  Seconds yaw_bias_memory{7200.0};  ///< after which the bias of the yaw rate is another
  Seconds gps_correlation{120.0};   ///< of the fixes' error, a Gauss-Markov process
  Seconds fix_wait{0.0};            ///< start at the origin when no fix comes in time; 0: never
  MatchingParams session;
};

}  // namespace limpet
