// SPDX-License-Identifier: MIT
// What the database says of the clocks.
#pragma once

#include "limpet/topics/topic.hpp"

namespace limpet {

/// The wall clock beside vehicle time, both without warp [s since 1970]. Whoever needs the date of
/// a log entry adds `ahead` to its time (divided by the warp).
struct WallClock {
  double vehicle = 0.0, wall = 0.0;
  double ahead = 0.0;  ///< wall less vehicle
  int steps = 0;       ///< how often it was set since the start
  template <class V>
  void Describe(V& visit) {
    visit("vehicle", vehicle), visit("wall", wall), visit("ahead", ahead), visit("steps", steps);
  }
};

namespace topics {
inline const auto kWallClock = Declare<WallClock>(
    "WALL_CLOCK",
    "the wall clock beside vehicle time, which does not step with it; embedded only as a fault",
    {.unit = "s", .rate = "every minute and on a step", .writers = {"LimpetDB"}});
}  // namespace topics

}  // namespace limpet
