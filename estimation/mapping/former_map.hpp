// SPDX-License-Identifier: MIT
// The former session as a map takes it up; on board and in `limpet change` alike.
#pragma once

#include "estimation/change/former_sight.hpp"
#include "estimation/mapping/map_params.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Where the former session looked from and how well it saw: its own camera, detector and limits if
/// the prior tells them, else `own`; in water as it found it, if it said so. Frames that its map
/// did not use are left out. Throws ConfigError if its parameters are none.
[[nodiscard]] FormerViews FormerViewsOf(const SessionPrior& prior, const MapParams& own);

}  // namespace limpet
