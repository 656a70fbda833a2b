// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace limpet {

/// `text` as one line that no terminal obeys: control characters, bytes that are no UTF-8, and
/// characters that turn the direction of writing are written out (\n, \x1b, \u202e). For text of
/// files that is repeated in messages; `OneLine` of the console library also minds its width.
[[nodiscard]] std::string HarmlessText(std::string_view text);

}  // namespace limpet
