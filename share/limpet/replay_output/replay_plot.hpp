// SPDX-License-Identifier: MIT
// Pictures of a stream's replay, without the truth: what the estimator said as it went against what
// it says at the end, and the map.
#pragma once

#include <string>

#include "estimation/replay/replay.hpp"

namespace limpet {

/// SVG: the online estimate less the smoothed one, with the online estimate's own 3-sigma bounds,
/// and dead reckoning less the smoothed estimate. REQUIRES: a replay with poses.
[[nodiscard]] std::string NavErrorPlot(const ReplayResult& result, const std::string& name);

/// SVG: the smoothed track from above, dead reckoning, and the objects with 3-sigma ellipses.
/// REQUIRES: a replay with poses.
[[nodiscard]] std::string NavMapPlot(const ReplayResult& result, const std::string& name);

}  // namespace limpet
