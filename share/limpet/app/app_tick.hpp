// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/config.hpp"

namespace limpet {

/// Ticks per second of MOOS time: AppTick of the app's block, or its default [Hz].
/// Throws ConfigError naming the line if it is not 0.01 to 1000.
[[nodiscard]] double AppTickRate(const ConfigBlock& block, double default_hz);

}  // namespace limpet
