// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace limpet {

/// The section of the page that says what each number means.
[[nodiscard]] std::string Explanations();

}  // namespace limpet
