// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace limpet {

/// A class is named by whoever wrote the detector: what would end a field of a table goes as `%20`.
[[nodiscard]] std::string ClassText(std::string_view name);
[[nodiscard]] std::string ClassFrom(std::string_view text);

}  // namespace limpet
