// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "limpet/planning/free_space.hpp"

namespace limpet {

/// Cells of a free space's raster, 1 for each that belongs.
struct JoinedRooms {
  std::vector<std::uint8_t> room;     ///< at least a turn's radius from every fence
  std::vector<std::uint8_t> passage;  ///< crossed on the way from one piece of it to another
};

/// `room`, one piece of what has room to turn, and all further pieces that a vehicle gets into from
/// there: off a full turn along its tangent, straight on inside the free space, and into a full
/// turn of the next piece. The same way leads back. Passages that bend are not found, nor such as
/// are so long and narrow that none of the courses tried (every two degrees) leads through.
[[nodiscard]] JoinedRooms JoinRooms(const FreeSpace& space, const std::vector<std::uint8_t>& room,
                                    double radius);

}  // namespace limpet
