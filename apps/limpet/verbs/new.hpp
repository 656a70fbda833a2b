// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

[[nodiscard]] int RunNew(std::span<const std::string> args);

}  // namespace limpet
