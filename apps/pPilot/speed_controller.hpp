// SPDX-License-Identifier: MIT
#pragma once

#include "apps/pPilot/integral_term.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {

/// Speed over ground to surge force: the drag of the wanted speed is fed forward, a PI controller
/// finds the rest (current, wear). The wanted speed is ramped.
class SpeedController {
 public:
  struct Gains {
    double speed = 1.0;              ///< acceleration per error [1/s]
    double integral = 0.25;          ///< [1/s^2]
    double max_acceleration = 0.25;  ///< of the ramp [m/s^2]
    double integral_limit = 0.7;     ///< [m/s^2]
  };
  SpeedController(const Gains& gains, const Hydrodynamics& hydro);

  /// Surge force [N] for speeds over ground [m/s].
  double Update(double speed, double desired_speed, double dt, bool is_saturated);
  /// Starts again from a speed.
  void Reset(double speed);

 private:
  Gains gains_;
  Hydrodynamics hydro_;
  IntegralTerm integral_;
  double reference_ = 0.0;
};

}  // namespace limpet
