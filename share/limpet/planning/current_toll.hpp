// SPDX-License-Identifier: MIT
// What a current adds to a way.
#pragma once

#include "limpet/planning/dubins_path.hpp"
#include "limpet/topics/energy.hpp"

namespace limpet {

/// Metres of still water that draw as much as `piece` does in the current, less its length [m].
/// Below 0 where it carries the vehicle along. An arc counts by its middle.
[[nodiscard]] double CurrentToll(const CourseCost& cost, const Pose2& from,
                                 const PathSegment& piece);
/// Toll of a whole path, its arcs taken piece by piece.
[[nodiscard]] double CurrentToll(const CourseCost& cost, const DubinsPath& path);

}  // namespace limpet
