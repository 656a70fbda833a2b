// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// The shortest way from `start`, outside the region, to the nearest place inside from which a
/// vehicle that cannot stop can go on, however far that is; by the transit's way points if there
/// are any and it has not merely drifted out. Nothing if the region leaves no room for a turn.
[[nodiscard]] std::optional<Option> TransitPath(const Pose2& start, const Region& region,
                                                Meters turn_radius);

/// Whether `option` ends inside: true of no way home, which may end anywhere.
[[nodiscard]] bool LeadsInto(const Region& region, const Option& option);

}  // namespace limpet
