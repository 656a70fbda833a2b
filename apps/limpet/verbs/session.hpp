// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet session recover <session>`: exit code.
[[nodiscard]] int RunSession(std::span<const std::string> args);

}  // namespace limpet
