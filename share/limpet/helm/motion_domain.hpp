// SPDX-License-Identifier: MIT
// The helm's decision variables as a mission writes them: `domain = speed:0:1:21`.
#pragma once

#include <span>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/helm/motion_decision.hpp"

namespace limpet {

/// Reads `name:low:high:points` lines into `domain`; every problem. Course, speed and depth must
/// each be there once: the helm stops the vehicle where one of them is undecided. The helm
/// maximises over the continuum; the points, two or more, are for those who display it.
[[nodiscard]] std::vector<ConfigProblem> ReadMotionDomain(std::span<const ConfigEntry> lines,
                                                          const SourceLine& block,
                                                          MotionDomain& domain);

}  // namespace limpet
