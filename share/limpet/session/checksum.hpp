// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace limpet {

/// XXH3 (64 bits) of the bytes, as 16 hexadecimal digits.
[[nodiscard]] std::string ChecksumOf(std::string_view bytes);

}  // namespace limpet
