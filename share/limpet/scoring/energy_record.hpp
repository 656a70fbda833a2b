// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "limpet/topics/energy.hpp"

namespace limpet {

/// What the vehicle says of its energy during a session.
struct EnergyRecord {
  EnergyState last;
  double home_wh = 0.0;  ///< the way home as it began; as it is now before that
  /// Least that was left beyond the way home and the reserve.
  double least_spare_wh = std::numeric_limits<double>::infinity();

  void Add(const EnergyState& state, bool is_on_the_way_home) {
    last = state;
    if (!is_on_the_way_home) home_wh = state.home_wh;
    least_spare_wh = std::min(least_spare_wh, state.spare_wh());
  }
};

}  // namespace limpet
