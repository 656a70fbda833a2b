// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {

/// Speed over ground to surge force: the drag of the wanted speed through the water is fed forward,
/// the error is pulled in proportionally; the integral part is DriftEstimate. The wanted speed is
/// ramped.
class SpeedController {
 public:
  struct Gains {
    double speed = 1.0;              ///< acceleration per error [1/s]
    double max_acceleration = 0.25;  ///< of the ramp [m/s^2]
  };
  SpeedController(const Gains& gains, const Hydrodynamics& hydro);

  /// Speed that there is and that is wanted, over ground [m/s].
  struct Input {
    double speed = 0.0;
    double desired = 0.0;
  };
  /// Moves the ramp on by `dt` [s]; what the speed lacks of it [m/s].
  double Lack(const Input& input, double dt);
  /// What the speed lacks, and the current along the nose [m/s].
  struct Demand {
    double lack = 0.0;
    double current = 0.0;
  };
  /// Surge force [N].
  [[nodiscard]] double Force(const Demand& demand) const;
  /// Starts again from a speed.
  void Reset(double speed);

 private:
  Gains gains_;
  Hydrodynamics hydro_;
  double reference_ = 0.0;
  double ramp_ = 0.0;
};

}  // namespace limpet
