// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

/// The first entry of `key` (case ignored), or nullptr.
[[nodiscard]] const ConfigEntry* FindEntry(const std::vector<ConfigEntry>& entries,
                                           std::string_view key);

}  // namespace limpet
