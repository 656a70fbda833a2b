// SPDX-License-Identifier: MIT
#include "limpet/app/app_tick.hpp"

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"

namespace limpet {

double AppTickRate(const ConfigBlock& block, double default_hz) {
  const ConfigEntry* entry = block.Find("AppTick");
  if (entry == nullptr) {
    return default_hz;
  }
  const std::optional<double> hz = ParseNumber(entry->value);
  if (!hz || *hz <= 0.0 || *hz > 1000.0) {
    throw ConfigError(
        {entry->where, entry->key,
         fmt::format("`{}` is not allowed; allowed: above 0 to 1000 hz", entry->value)});
  }
  return *hz;
}

}  // namespace limpet
