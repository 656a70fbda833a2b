// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/vehicle/thruster_layout.hpp"

namespace limpet {

/// Turns a wanted wrench into thruster commands: weighted pseudo-inverse, and when thrusters
/// saturate yaw is served first, then heave, then pitch, then surge and sway by one common factor,
/// so that direction is kept. Roll cannot be commanded, nor can pitch with thrusters that make none
/// (`ThrusterLayout::ControlledAxes`).
class ThrustAllocation {
 public:
  struct Result {
    ThrusterVector command;     ///< normalised, each in [-1, 1]
    Wrench achieved;            ///< what these commands make [N, N m]
    bool is_saturated = false;  ///< something of the wanted wrench had to be left out
  };
  /// `price` weighs the use of each thruster; equal prices spread the load.
  ThrustAllocation(const ThrusterLayout& layout, const ThrusterVector& price);
  explicit ThrustAllocation(const ThrusterLayout& layout)
      : ThrustAllocation(layout, ThrusterVector::Ones()) {}

  [[nodiscard]] Result Allocate(const Wrench& wanted) const;

 private:
  ThrusterLayout layout_;
  ThrusterWrenches wrench_per_thrust_;
  Eigen::Matrix<double, kMostThrusters, 6>
      thrust_per_wrench_;  // columns of what cannot be commanded are zero
};

}  // namespace limpet
