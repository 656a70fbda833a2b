// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/planning/objective.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// A short path that passes every target (at most the eight nearest), in the best order; nothing
/// without targets. For change sessions: former objects first.
[[nodiscard]] std::optional<Option> TargetTour(const Pose2& start, const Region& region,
                                               const Objective& objective, Meters turn_radius);

}  // namespace limpet
