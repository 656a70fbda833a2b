// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/topics/simulation.hpp"

namespace limpet {

/// A vehicle that hangs still.
inline SimTruth AtRest() {
  SimTruth truth;
  truth.yaw = 1.0;
  truth.down = 3.5;
  truth.fz = -9.81;
  return truth;
}

}  // namespace limpet
