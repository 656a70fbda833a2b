// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "limpet/survey/simple_polygon.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Enclosed ground counts as an obstacle's own up to this size [m^2]: more of it is rather a basin
/// whose mouth has not been found.
inline constexpr double kMostEnclosed = 200.0;

/// Cells of a grid that obstacles stand on, by index, in order. A sonar sees walls, not what is
/// behind them: what is in no outline but shut in by outlines, with gaps of up to a metre between
/// them, belongs to the obstacle as well, unless the vehicle is in there or more than
/// `kMostEnclosed` of it is. Outlines that are none are left out. Where nothing stands nothing is
/// done.
[[nodiscard]] std::vector<std::uint32_t> StandingGround(
    const std::vector<Obstacle>& obstacles, const GridFrame& frame,
    const std::optional<PlanePoint>& vehicle = std::nullopt);

}  // namespace limpet
