// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {

/// Keeps the velocity over ground along the nose: in a turn it feeds forward the centripetal force,
/// in a current the drag of holding against it. So heading is course, and the camera's footprint
/// stays square to the path. The integral part is DriftEstimate.
class SwayController {
 public:
  struct Gains {
    double speed = 0.7;       ///< acceleration per error [1/s]
    double max_force = 21.0;  ///< [N]; leaves room for surge
  };
  struct Input {
    double u = 0.0, v = 0.0;                  ///< body velocity over ground [m/s]
    double turn_rate = 0.0;                   ///< measured [rad/s]
    double current_u = 0.0, current_v = 0.0;  ///< in body axes [m/s]
  };
  SwayController(const Gains& gains, const Hydrodynamics& hydro);

  /// Sway force [N].
  [[nodiscard]] double Force(const Input& input) const;

 private:
  Gains gains_;
  Hydrodynamics hydro_;
};

}  // namespace limpet
