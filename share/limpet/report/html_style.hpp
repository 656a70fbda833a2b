// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace limpet {

/// The page's style sheet, light and dark.
[[nodiscard]] std::string PageStyle();

}  // namespace limpet
