// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/control/integral_term.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {

/// Depth to heave force: a reference moves towards the wanted depth no faster than the vehicle can
/// dive, PID follows it; drag of the reference's speed and net buoyancy are fed forward. At the
/// surface buoyancy alone holds the vehicle.
class DepthController {
 public:
  struct Gains {
    double depth = 0.8;              ///< acceleration per error [1/s^2]
    double rate = 1.6;               ///< acceleration per error of depth rate [1/s]
    double integral = 0.15;          ///< [1/s^3]
    double integral_limit = 0.15;    ///< [m/s^2]
    double approach = 0.5;           ///< reference's speed per distance left [1/s]
    double max_rate = 0.3;           ///< of the reference [m/s]
    double max_acceleration = 0.15;  ///< of the reference [m/s^2]
    double max_lead = 0.5;           ///< of the reference over the vehicle [m]
    double afloat_depth = 0.25;      ///< shallower than this, buoyancy holds the vehicle [m]
  };
  struct Input {
    double depth = 0.0, depth_rate = 0.0;  ///< [m, m/s], down positive
    double desired_depth = 0.0;
  };
  DepthController(const Gains& gains, const Hydrodynamics& hydro);

  /// Heave force [N], down positive.
  double Update(const Input& input, double dt, bool is_saturated);
  /// Starts again from where the vehicle is.
  void Reset(double depth);

 private:
  /// Moves the reference on; returns its acceleration [m/s^2].
  double MoveReference(const Input& input, double dt);

  Gains gains_;
  Hydrodynamics hydro_;
  IntegralTerm integral_;
  double reference_ = 0.0;
  double reference_rate_ = 0.0;
};

}  // namespace limpet
