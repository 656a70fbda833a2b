// SPDX-License-Identifier: MIT
// Where a vehicle without a path is better off than at a border: farther inside its region.
#pragma once

#include <optional>

#include "limpet/planning/region.hpp"

namespace limpet {

/// A place with room around it: the middle of a rectangle, else of the places with the most room
/// (of 6, 4, 2, 1 m) the nearest to `here`. Nothing where the region has room for none.
[[nodiscard]] std::optional<PlanePoint> PlaceInside(const Region& region, const PlanePoint& here);

}  // namespace limpet
