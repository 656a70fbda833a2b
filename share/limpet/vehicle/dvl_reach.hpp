// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// What the vehicle's DVL (Nortek DVL1000 class) can tell of the seabed; heights above it [m].
struct DvlReach {
  double nearest_m = 0.3;  ///< of bottom lock
  double farthest_m = 50.0;
  /// A beam that ends higher above the others is taken for false and not mapped.
  double tallest_object_m = 3.0;
};

}  // namespace limpet
