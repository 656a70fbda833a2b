// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/planning/leg_path.hpp"
#include "limpet/planning/region.hpp"

namespace limpet {

/// The legs of a way through `region` from one place in it to another, for PathAlong: the motions
/// stay inside, and only the end must be passed. Nothing if there is no such way, or the region is
/// a plain rectangle, in which straight on is the way. `region` must outlive them.
[[nodiscard]] std::optional<std::vector<LegEnd>> LegsInside(const Region& region,
                                                            const PlanePoint& from,
                                                            const PlanePoint& to);

}  // namespace limpet
