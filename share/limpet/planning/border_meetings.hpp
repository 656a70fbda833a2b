// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/planning/pose2.hpp"
#include "limpet/survey/simple_polygon.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// An arc or line and where it begins.
struct PlacedSegment {
  Pose2 from;
  PathSegment segment;
};

/// Adds the lengths along `piece` [m] at which it meets the line at `distance` [m] from the
/// polygon's border, on either side: sides shifted, circles around corners. Some of what is added
/// may be no border, as another side is nearer there.
void AddMeetings(const PlacedSegment& piece, const SimplePolygon& polygon, double distance,
                 std::vector<double>& lengths);

}  // namespace limpet
