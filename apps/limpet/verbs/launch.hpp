// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet launch <file.moos>`: the same as pLaunch.
[[nodiscard]] int RunLaunchVerb(std::span<const std::string> args);

}  // namespace limpet
