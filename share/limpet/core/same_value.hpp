// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace limpet {

/// Whether two texts state one value: numbers that differ by their writing or their last digits, or
/// the same text.
[[nodiscard]] bool IsSameValue(std::string_view a, std::string_view b);

}  // namespace limpet
