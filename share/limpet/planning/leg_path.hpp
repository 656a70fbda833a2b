// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/dubins_path.hpp"
#include "limpet/survey/simple_polygon.hpp"

namespace limpet {

/// Where a leg of a way ends, and what the motion to there must keep.
struct LegEnd {
  PlanePoint at_W;
  std::function<bool(const DubinsPath&)> allows;
  /// False: a hint; what goes on without it and is allowed may be shorter.
  bool must_be_passed = true;
  /// How it must be passed [rad]; any way if absent.
  std::optional<double> heading{};
};

/// How the last of them may be reached; always true if empty.
using AllowsEnd = std::function<bool(const Pose2&)>;

/// The shortest motion from `start` past the ends of the legs, of some headings at each of them.
/// Legs that no motion of those keeps are flown all the same. Nothing if there is no leg, or the
/// end is allowed with no heading.
[[nodiscard]] std::optional<DubinsPath> PathAlong(const Pose2& start,
                                                  const std::vector<LegEnd>& legs, Meters radius,
                                                  const AllowsEnd& allows_end = {});

/// What is left of a way by these places for one who is at `at`: from the end of the leg beside it
/// on, or all of it if that is still ahead; without a corner that it has just gone round. REQUIRES:
/// one place or more.
[[nodiscard]] std::vector<PlanePoint> RestOfWay(const std::vector<PlanePoint>& places,
                                                const PlanePoint& at, Meters turn_radius);

}  // namespace limpet
