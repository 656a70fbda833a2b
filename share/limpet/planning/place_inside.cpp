// SPDX-License-Identifier: MIT
#include "limpet/planning/place_inside.hpp"

#include "limpet/planning/room.hpp"

namespace limpet {

std::optional<PlanePoint> PlaceInside(const Region& region, const PlanePoint& here) {
  if (region.free_space() == nullptr) {
    return PlanePoint(0.5 * (region.north_min() + region.north_max()),
                      0.5 * (region.east_min() + region.east_max()));
  }
  for (const double room : {6.0, 4.0, 2.0, 1.0}) {  // [m]
    if (auto place = NearestRoom(*region.free_space(), here, room)) return place;
  }
  return std::nullopt;
}

}  // namespace limpet
