// SPDX-License-Identifier: MIT
#include "limpet/app/app_tick.hpp"

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr double kSlowestTick_hz = 0.01;  // slower, an app is as good as dead: it answers nobody
constexpr double kFastestTick_hz = 1000.0;

}  // namespace

double AppTickRate(const ConfigBlock& block, double default_hz) {
  const ConfigEntry* entry = block.Find("AppTick");
  if (entry == nullptr) {
    return default_hz;
  }
  const std::optional<double> hz = ParseNumber(entry->value);
  if (!hz || *hz < kSlowestTick_hz || *hz > kFastestTick_hz) {
    throw ConfigError({entry->where, entry->key,
                       fmt::format("`{}` is not allowed; allowed: {:g} to {:g} Hz", entry->value,
                                   kSlowestTick_hz, kFastestTick_hz)});
  }
  return *hz;
}

}  // namespace limpet
