// SPDX-License-Identifier: MIT
// Where in a free space there is room for turns, and ways through it, on its raster.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/free_space.hpp"

namespace limpet {

/// Cells of the raster that are at least `radius` [m] from every fence, and hang together: of
/// several such pieces the largest. A full turn fits around each of them, and turn by turn a
/// vehicle gets from each to each. 1 where that is so; all 0 if there is none.
[[nodiscard]] std::vector<std::uint8_t> RoomToTurn(const FreeSpace& space, double radius);

/// The piece of such room that is nearest to `from` by ways that are free, however narrow; of those
/// that are farther by no more than `radius` the largest. All 0 if there is none, or `from` is not
/// in the raster.
[[nodiscard]] std::vector<std::uint8_t> RoomToTurnFrom(const FreeSpace& space,
                                                       const PlanePoint& from, double radius);

/// The place of the former room that is nearest to `from`; nothing if there is none.
[[nodiscard]] std::optional<PlanePoint> NearestRoom(const FreeSpace& space, const PlanePoint& from,
                                                    double radius);

/// Share of the room to turn in `space` from which the nearest room to turn in `smaller`, a part of
/// it, is no farther than `reach` and a cell along the farther axis. Fences of `smaller`, nearer by
/// `reach`, have cut off or closed the rest.
[[nodiscard]] double RoomInReach(const FreeSpace& space, const FreeSpace& smaller, Meters radius,
                                 Meters reach);

/// Straight legs from `from` to `to` that stay inside, about as short as can be, but a metre off
/// all fences where that is possible: the places where they meet and `to`. Nothing if one of the
/// two is not inside, or there is no way.
[[nodiscard]] std::optional<std::vector<PlanePoint>> LegsThrough(const FreeSpace& space,
                                                                 const PlanePoint& from,
                                                                 const PlanePoint& to);

}  // namespace limpet
