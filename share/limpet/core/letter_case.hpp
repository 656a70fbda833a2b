// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace limpet {

/// Letters of ASCII alone change: bytes of other letters stay as they are.
[[nodiscard]] std::string UpperCase(std::string_view text);
[[nodiscard]] std::string LowerCase(std::string_view text);

}  // namespace limpet
