// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

/// The macros that a mission or behavior file, or a fragment that it includes, defines and none of
/// them uses, as `$(NAME)` or in a condition: whichever way conditions go, what stands there counts
/// as used. Each with the nearest macro that is used. None if a file cannot be read.
[[nodiscard]] std::vector<ConfigProblem> UnusedMacros(const std::filesystem::path& file);

}  // namespace limpet
