// SPDX-License-Identifier: MIT
#include "limpet/waypoints/leg_odometer.hpp"

#include <utility>

#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {

void LegOdometer::Move(const MapPoint& at) {
  if (last_) travelled_m_ += DistanceBetween(at, *last_);
  last_ = at;
}

bool LegOdometer::Reach(const MapPoint& at, Seconds now, double speed) {
  const bool counts = from_ && !std::exchange(is_spoilt_, false);
  if (counts) {
    const double straight = DistanceBetween(at, *from_);
    leg_ = {.straight_m = straight,
            .travelled_m = travelled_m_,
            .straight_s = speed > 0.0 ? straight / speed : 0.0,
            .travelled_s = (now - since_).value()};
    all_.straight_m += leg_.straight_m, all_.travelled_m += leg_.travelled_m;
    all_.straight_s += leg_.straight_s, all_.travelled_s += leg_.travelled_s;
  }
  is_spoilt_ = false;
  from_ = at;
  since_ = now;
  travelled_m_ = 0.0;
  return counts;
}

}  // namespace limpet
