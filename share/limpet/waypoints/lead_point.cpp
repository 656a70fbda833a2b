// SPDX-License-Identifier: MIT
#include "limpet/waypoints/lead_point.hpp"

#include <algorithm>

namespace limpet {

MapPoint LeadPoint(const MapLeg& leg, const MapPoint& at, const LeadRule& rule) {
  const double length = leg.length();
  if (rule.lead <= 0.0 || length <= 0.0) {
    return leg.to;
  }
  const double along = std::clamp(leg.Along(at), 0.0, length);
  double ahead = rule.lead;
  if (const double off = DistanceBetween(at, leg.At(along)); off < rule.damper) {
    ahead *= 1.0 + 2.0 * (1.0 - off / rule.damper);
  }
  return leg.At(std::min(along + ahead, length));
}

}  // namespace limpet
