// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// What the vehicle's DVL (Nortek DVL1000 class) can tell of the seabed; heights above it [m].
struct DvlReach {
  double nearest_m = 0.3;  ///< of bottom lock
  double farthest_m = 50.0;
};

}  // namespace limpet
