// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "limpet/tuning/race.hpp"

namespace limpet {

/// The next settings to try: each where a Gaussian process over what was flown expects the greatest
/// improvement on the best so far; after each the process is told its own prediction there, so that
/// they spread. The process stands for the mean paired difference from the default, its errors
/// from the runs' own scatter. Settings that broke the constraints count as the worst seen. Fewer
/// than `count` when all levels are tried.
[[nodiscard]] std::vector<SettingValues> MostPromising(const ParameterSpace& space,
                                                       const std::vector<Contender>& flown,
                                                       int count, std::uint64_t seed);

}  // namespace limpet
