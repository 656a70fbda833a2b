// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/config.hpp"

namespace limpet {

/// Where a word of the command line stands, for complaints about it.
[[nodiscard]] inline SourceLine CommandLine() { return {.file = "command line", .line = 0}; }

/// A command line that cannot be followed, for `text`, which is about the word `key`.
[[nodiscard]] inline ConfigError CommandLineError(const std::string& key, const std::string& text) {
  return ConfigError(ConfigProblem{CommandLine(), key, text});
}

}  // namespace limpet
