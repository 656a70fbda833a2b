// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

/// True if one of the names is among the keys that an update gives, whatever their case.
[[nodiscard]] inline bool HasKey(const std::vector<std::string>& keys,
                                 std::initializer_list<std::string_view> names) {
  return std::ranges::any_of(keys, [&names](const std::string& key) {
    return std::ranges::any_of(
        names, [&key](std::string_view name) { return EqualsIgnoringCase(key, name); });
  });
}

}  // namespace limpet
