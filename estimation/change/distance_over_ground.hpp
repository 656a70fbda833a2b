// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// Distance between where two objects are believed to be, whatever their depths [m].
[[nodiscard]] inline double DistanceOverGround(const ObjectEstimate& a, const ObjectEstimate& b) {
  return (a.p_W - b.p_W).head<2>().norm();
}

}  // namespace limpet
