// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

inline constexpr const char* kTransitSource = "transit";

/// The shortest way from `start`, outside the region, to the nearest place inside from which a
/// vehicle that cannot stop can go on, however far that is; by what is left of the transit from
/// `begin` on, where the survey began, if there is a transit. Nothing if the region leaves no room
/// for a turn.
[[nodiscard]] std::optional<Option> TransitPath(const Pose2& start, const PlanePoint& begin,
                                                const Region& region, Meters turn_radius);

/// The transit as places: `begin`, its way points, and where it enters the region; empty without a
/// transit, or room inside.
[[nodiscard]] std::vector<PlanePoint> TransitPlaces(const PlanePoint& begin, const Region& region,
                                                    Meters turn_radius);

/// Whether a vehicle here is on its way in by the region's transit: farther outside than it drifts.
[[nodiscard]] bool IsInTransit(const Region& region, const Pose2& pose);

/// Whether `option` ends inside: true of no way home, which may end anywhere.
[[nodiscard]] bool LeadsInto(const Region& region, const Option& option);

}  // namespace limpet
