// SPDX-License-Identifier: MIT
#pragma once

#include "apps/pPilot/integral_term.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {

/// Keeps the velocity over ground along the nose: in a turn it feeds forward the centripetal force,
/// in a current its integral finds the force that holds against the flow. So heading is course, and
/// the camera's footprint stays square to the path.
class SwayController {
 public:
  struct Gains {
    double speed = 1.2;           ///< acceleration per error [1/s]
    double integral = 0.4;        ///< [1/s^2]
    double integral_limit = 0.3;  ///< [m/s^2]; 18 N, enough for 0.4 m/s across
    double max_force = 21.0;      ///< [N]; leaves room for surge
  };
  struct Input {
    double u = 0.0, v = 0.0;  ///< body velocity over ground [m/s]
    double turn_rate = 0.0;   ///< wanted [rad/s]
  };
  SwayController(const Gains& gains, const Hydrodynamics& hydro);

  /// Sway force [N].
  double Update(const Input& input, double dt, bool is_saturated);
  void Reset() { integral_.Reset(); }

 private:
  Gains gains_;
  Hydrodynamics hydro_;
  IntegralTerm integral_;
};

}  // namespace limpet
