// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

/// A macro that nothing uses, with the nearest that is used.
struct UnusedMacro {
  ConfigProblem problem;
  /// Others of its numbered series are used (`ZONE_2` for `ZONE_10`): it is meant to do something.
  bool is_beyond_its_series = false;
};

/// The macros that a mission or behavior file, or a fragment that it includes, defines and none of
/// them uses, as `$(NAME)` or in a condition: whichever way conditions go, what stands there counts
/// as used. None if a file cannot be read.
[[nodiscard]] std::vector<UnusedMacro> UnusedMacros(const std::filesystem::path& file);

}  // namespace limpet
