// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/control/integral_term.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {

/// Heading to yaw moment: error to a wanted turn rate, on top of the rate fed forward; rate error
/// and the drag of the wanted rate to a moment. Equals PD with rate feed-forward while the wanted
/// rate is within its limit. The Munk moment of a flow from the side is fed forward: the body has
/// no fins and would turn across a current.
class HeadingController {
 public:
  struct Gains {
    double heading = 1.3;         ///< wanted rate per error [1/s]
    double rate = 3.2;            ///< wanted acceleration per rate error [1/s]
    double integral = 0.5;        ///< acceleration per error and second [1/s^3]
    double max_rate = 0.5;        ///< of what the error asks for [rad/s]
    double integral_limit = 2.0;  ///< [rad/s^2]
  };
  struct Input {
    double yaw = 0.0, yaw_rate = 0.0;                   ///< [rad, rad/s]
    double desired_yaw = 0.0, desired_turn_rate = 0.0;  ///< [rad, rad/s]
    /// Velocity through the water while the course is held: of v_water the current's part only,
    /// since feeding the measured sway back into yaw would destabilise it [m/s].
    double u_water = 0.0, v_water = 0.0;
  };
  HeadingController(const Gains& gains, const Hydrodynamics& hydro);

  /// Yaw moment [N m].
  double Update(const Input& input, double dt, bool is_saturated);
  void Reset() { integral_.Reset(); }

 private:
  Gains gains_;
  double inertia_;
  Hydrodynamics hydro_;
  IntegralTerm integral_;
};

}  // namespace limpet
